// The middle between the limits decides, with x as it will be.
  const real next = x + h * rate;
  LimitRow row{x - range.lower, 1};
  if (range.upper - next < next - range.lower) row = {range.upper - x, -1};
  row.live = row.C - h * std::abs(rate) < real(0.1) * h || range.lower == range.upper;
  return row;
