// region: 3
// A half, h/T times.
  return 1 - std::pow(real(0.5), h / half_time);
