package simgsm.center.ui.ladder;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.draw.SvgCanvas;

/** Exports the visible messages. */
final class LadderFile {
    private static final double LEAST_WIDTH_UNITS = 640;
    private static final double LINE_UNITS = 120;

    private LadderFile() {}

    /** Returns each message with its time, direction and name, then its fields and octets. */
    static String text(List<LadderRow> rows, Locale language) {
        return rows.stream()
                .map(row -> row + "\n"
                        + MessageFields.lines(MessageFields.of(row, language)).indent(4))
                .collect(Collectors.joining("\n"));
    }

    /** Draws the ladder with one rung for each message, light whatever the window's theme. */
    static String svg(List<LadderRow> rows, Lifelines lifelines, String title) {
        SvgCanvas canvas = new SvgCanvas(ink -> ink.hex(Appearance.LIGHT));
        double width = Math.max(
                LEAST_WIDTH_UNITS,
                2 * LINE_UNITS + LINE_UNITS * lifelines.names().size());
        LadderDrawing drawing = new LadderDrawing(canvas, lifelines, width);
        drawing.heads(LadderDrawing.HEAD_UNITS);
        double y = LadderDrawing.HEAD_UNITS;
        for (LadderRow row : rows) {
            canvas.moved(0, y, 0, () -> drawing.rung(row, LadderDrawing.RUNG_UNITS, Ink.CARD));
            y += LadderDrawing.RUNG_UNITS;
        }
        return canvas.document(width, y, title);
    }
}
