"""The chapters' pages of the site: behind a paragraph that compares values of one setting by links
into the live page stands its scene, with that one setting and the lines of code that use it."""
import re
from html import escape, unescape
from urllib.parse import parse_qsl

from base import house
from website import gallery

BLOCK = re.compile(r"<(p|li)\b[^>]*>(?:(?!</?\1\b).)*?live\.html#(?:(?!</?\1\b).)*?</\1>", re.S)
LINK = re.compile(r'<a href="live\.html#([^"]+)"')
NO_SETTING = {"scene", "t", "iteration", "block", "view"}
# A setting: where it is used, as files, the first of some lines, and how many.
CODE = {
    "beta": (("engine/block.h", "real bias_rate = row.beta / h, softness = 0;", 1),
             ("engine/block.h", "return std::min(std::max(bias_rate * C, -most), most);", 1)),
    "iterations": (("engine/sequential_impulses.cpp",
                    "for (int i = 0; i < iterations; ++i) iterate(bodies);", 1),
                   ("engine/sequential_impulses.cpp",
                    "real e[N];  // velocity error of each row: J V + bias", 2)),
    "strength": (("joints/free_coordinate.h", "if (strength > 0)", 6),),
    "relaxation": (("engine/block.h",
                    "const real mass_scale = relaxation / (1 + softness);", 1),),
    "tilt": (("engine/sequential_impulses.cpp",
              "if (N == 1 && block.settings.follows != 0) {"
              "  // bounds are -+upper * impulse[follows]", 5),),
    "projections": (("engine/steps/step.cpp",
                     "for (int i = 0; i < how.projections; ++i) project_positions(world);", 1),
                    ("engine/steps/projection.cpp",
                     "for (const auto& joint : world.joints()) {", 4)),
    "substeps": (("engine/steps/step.cpp", "const real h_sub = h / real(how.substeps);", 5),),
    "direct": (("chapters/09_direct/active_set.cpp", "if (!factored) {", 6),),
    "newton": (("direct/positions.cpp", "move_onto_constraints(bodies_, "
                "double(h_), newton, 0, *this, own_.start);", 1),)}


def states(block):
    """What its links open: [{setting: value}]."""
    return [dict(parse_qsl(unescape(state))) for state in LINK.findall(block)]


def setting_of(found):
    """The one setting in which the links into one scene differ; or which the only link
    sets; None if there is no such one."""
    same = [state for state in found if state.get("scene") == found[0].get("scene")]
    names = [name for name in {name: 0 for state in same for name in state}
             if name not in NO_SETTING and len({state.get(name) for state in same}) > 1]
    if not names and len(same) == 1:
        names = [name for name in same[0] if name not in NO_SETTING]
    if "direct" in names:  # which sets others, too
        return "direct"
    return next((name for name in names if name in CODE), None)


def lines_of(file, first, count):
    """Some lines of a file, without their common indent."""
    lines = (house.ROOT / file).read_text(encoding="utf-8").split("\n")
    at = [k for k, line in enumerate(lines) if line.strip() == first]
    if len(at) != 1:
        raise gallery.GalleryError(f"{file} has {len(at)} lines '{first}', which the site shows "
                                   "beside its settings: see CODE in tools/website/experiments.py")
    indent = len(lines[at[0]]) - len(first)
    return [line[indent:] for line in lines[at[0]:at[0] + count]]


def code_of(setting):
    """Where it is used, as a listing."""
    out, before = "", None
    for piece in CODE[setting]:
        if piece[0] != before:
            out += ("</div>" if before else "") + (
                f'<p>In <code>{piece[0]}</code>:</p><div class="fragment">')
        else:
            out += '<div class="line">...</div>'
        out += "".join(f'<div class="line">{escape(line)}</div>' for line in lines_of(*piece))
        before = piece[0]
    return f"{out}</div>"


def experiment(block, number):
    """The scene behind a paragraph, or nothing."""
    found = states(block)
    setting = setting_of(found)
    if not setting:
        return ""
    address = f"live.html#{LINK.search(block)[1]}&amp;only={setting}"
    return (f'<div class="experiment" id="experiment-{number}">'
            f'<div class="code">{code_of(setting)}</div>'
            f'<iframe title="The scene {found[0]["scene"]}, with the setting {setting}" '
            f'data-only="{setting}" data-src="{address}"></iframe></div>')


def with_experiments(text):
    """A chapter's page with the scenes of its paragraphs; their links lead into these."""
    out, end, number = [], 0, 0
    for block in BLOCK.finditer(text):
        if scene := experiment(block[0], number + 1):
            number += 1
            linked = LINK.sub(lambda link: f'{link[0]} data-experiment="experiment-{number}"',
                              block[0])
            if block[1] == "li":
                linked = linked[:-len("</li>")] + scene + "</li>"
                scene = ""
            out += [text[end:block.start()], linked, scene]
            end = block.end()
    return "".join(out) + text[end:]
