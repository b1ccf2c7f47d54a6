"""Results as a table, for a terminal and for docs/performance.md."""

from bars import ratio

BEGIN = "<!-- table: written by ./dev bench --write-table -->"
END = "<!-- end of the table -->"


def amount(seconds):
    """At most four digits and a unit."""
    for unit, factor in (("s", 1.0), ("ms", 1e3), ("us", 1e6)):
        if seconds * factor >= 1.0 or unit == "us":
            return f"{seconds * factor:.3g} {unit}"


def timing(value):
    share = value["spread"] / value["median"] if value["median"] else 0.0
    return f"{amount(value['median'])} ±{100 * share:.0f}%"


def remarks(row):
    parts = []
    if "engine" in row:
        parts.append("drawn by " + row["engine"])
    if "polygons" in row:
        parts.append(f"{1e-6 * row['polygons'] / row['wall']['median']:.3g} M polygons/s")
    if "classification" in row:
        parts.append(f"after {amount(row['classification'])} of classification")
    if "peakMiB" in row:
        parts.append(f"{row['peakMiB']:.0f} MiB")
    if row.get("areaOff", 0.0) > 1e-4:
        parts.append(f"area off by {100 * row['areaOff']:.2g}%")
    if "fragments" in row:
        parts.append(f"{1e-6 * row['fragments']:.1f} M fragments")
    return ", ".join(parts)


def cells(job):
    """For each row: who, wall, CPU, ours by this one's, PSNR, remarks."""
    base = next((row for row in job["rows"] if row["role"] == job["base"] and "absent" not in row), None)
    for row in job["rows"]:
        if "absent" in row:
            yield [row["who"], "-", "-", "", "", row["absent"]]
            continue
        ours = f"{ratio(base, row):.3g}" if base and base is not row else ""
        psnr = f"{row['psnr']:.1f}" if "psnr" in row else ""
        yield [row["who"], timing(row["wall"]), timing(row["cpu"]), ours, psnr, remarks(row)]


HEADINGS = ["who", "wall", "CPU", "ours by it", "PSNR dB", "remarks"]


def title(job):
    text = f"{job['name']}, {job['size']}"
    slices = next((row["psnrOfSlices"] for row in job["rows"] if "psnrOfSlices" in row), None)
    if slices is not None:
        text += f"; samples a voxel apart in float64: {slices:.1f} dB"
    return text


def printed(job):
    lines = [title(job)]
    widths = (33, 16, 16, 12, 9)
    for row in [HEADINGS, *cells(job)]:
        lines.append("  " + "".join(f"{cell:{width}}" for cell, width in zip(row, widths)) + row[5])
    if job["disturbed"]:
        lines.append(f"  {job['rounds']} rounds used, {job['disturbed']} disturbed")
    return "\n".join(line.rstrip() for line in lines) + "\n"


def markdown(results):
    lines = [BEGIN, "", conditions(results), ""]
    for job in results["jobs"]:
        lines += [f"**{title(job)}**", "", "| " + " | ".join(HEADINGS) + " |", "|---|---|---|---|---|---|"]
        lines += ["| " + " | ".join(row) + " |" for row in cells(job)]
        lines.append("")
    lines += ["| bar | reached | wanted | |", "|---|---|---|---|"]
    for bar in results["bars"]:
        if bar["state"] == "not measured":
            lines.append(f"| {bar['name']} | {bar['reason']} | | not measured |")
        else:
            lines.append(f"| {bar['name']} | {bar['value']:.4g}{bar['unit']} | "
                         f"{bar['sense']} {bar['limit']:.4g}{bar['unit']} | {bar['state']} |")
    return "\n".join(lines + ["", END])


def conditions(results):
    machine, noise = results["machine"], results["noise"]
    rounds = sorted({job["rounds"] for job in results["jobs"]})
    counted = f"{rounds[0]} to {rounds[-1]}" if len(rounds) > 1 else f"{rounds[0]}"
    return (f"{results['date']}, {machine['processor']}, {machine['cores']} cores, {machine['system']}; "
            f"{counted} rounds a job. {noise_line(noise)}")


def noise_line(noise):
    return (f"Noise: the times' spread within a row is {100 * noise['spread']:.1f}% (median of the rows; worst "
            f"{100 * noise['worstSpread']:.0f}%), the processor's speed varied by {100 * noise['loopSpread']:.0f}% "
            f"between a row's rounds, load average {noise['loadBefore']:.2f} before and {noise['loadAfter']:.2f} after, "
            f"{noise['disturbed']} of {noise['tried']} rounds disturbed by other programs.")


def write_table(results, path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    start, end = text.find(BEGIN), text.find(END)
    if start < 0 or end < start:
        raise ValueError(f"{path}: expected the lines '{BEGIN}' and '{END}', found no such pair")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text[:start] + markdown(results) + text[end + len(END):])
