package simgsm.ui;

import java.awt.BasicStroke;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Stroke;
import java.awt.geom.Path2D;
import javax.swing.Icon;
import simgsm.draw.Ink;
import simgsm.draw.Outline;

/** The suite's pictograms: lines and filled areas on a square of 16 units, in the syntax of {@link Outline#parse}. */
public enum Symbol {
    CALL(
            "",
            "M5.1 2.04C4.9 2.04 4.69 2.12 4.54 2.27L2.27 4.54C1.96 4.85 1.96 5.35 2.27 5.67L2.58 5.97C2.37 7.98 3.08 10"
                    + " 4.54 11.46C5.83 12.76 7.57 13.46 9.34 13.46C9.57 13.46 9.8 13.45 10.03 13.42L10.33 13.73"
                    + "C10.49 13.88 10.69 13.96 10.9 13.96C11.1 13.96 11.31 13.88 11.46 13.73L13.73 11.46"
                    + "C14.04 11.15 14.04 10.65 13.73 10.33L12.38 8.99C12.23 8.83 12.02 8.76 11.82 8.76"
                    + "C11.61 8.76 11.41 8.83 11.25 8.99L10.11 10.13C9.03 10.1 7.97 9.67 7.15 8.85C6.33 8.03 5.9 6.97"
                    + " 5.87 5.89L7.01 4.75C7.32 4.43 7.32 3.93 7.01 3.62L5.67 2.27C5.51 2.12 5.31 2.04 5.1 2.04Z"),
    HANG_UP(
            "",
            "M8 4.35C5.94 4.35 4.01 5.29 2.73 6.85L2.3 6.85C1.86 6.85 1.5 7.21 1.5 7.65L1.5 10.85C1.5 11.29 1.86 11.65"
                    + " 2.3 11.65L4.2 11.65C4.64 11.65 5 11.29 5 10.85L5 9.23C5.79 8.5 6.84 8.05 8 8.05"
                    + "C9.16 8.05 10.21 8.5 11 9.23L11 10.85C11 11.29 11.36 11.65 11.8 11.65L13.7 11.65"
                    + "C14.14 11.65 14.5 11.29 14.5 10.85L14.5 7.65C14.5 7.21 14.14 6.85 13.7 6.85L13.27 6.85"
                    + "C11.99 5.29 10.06 4.35 8 4.35Z"),
    ENVELOPE("R1.5 3.5 13 9.5 1M2 4.5L8 9L14 4.5", ""),
    ENVELOPE_OPEN("M1.5 6.5L8 2L14.5 6.5L14.5 13.5L1.5 13.5L1.5 6.5L8 10.5L14.5 6.5", ""),
    MENU("M3 4.5L13 4.5M3 8L13 8M3 11.5L13 11.5", ""),
    UP("M3.5 10.5L8 6L12.5 10.5", ""),
    DOWN("M3.5 6L8 10.5L12.5 6", ""),
    LEFT("M10 3.5L5.5 8L10 12.5", ""),
    RIGHT("M6 3.5L10.5 8L6 12.5", ""),
    OK("O8 8 4", ""),
    CLOSE("M4 4L12 12M12 4L4 12", ""),
    PLUS("M8 3L8 13M3 8L13 8", ""),
    MINUS("M3 8L13 8", ""),
    PLAY("", "M5 3L13 8L5 13Z"),
    PAUSE("", "R4 3 2.8 10 0R9.2 3 2.8 10 0"),
    STEP("", "M3.5 3.5L10 8L3.5 12.5ZR11 3.5 2 9 0"),
    POWER("A3 3.5 10 10 125 290M8 2L8 7.5", ""),
    MOTOR(
            "O8 8 5M13 8L14.6 8M10.5 12.33L11.3 13.72M5.5 12.33L4.7 13.72M3 8L1.4 8M5.5 3.67L4.7 2.28"
                    + "M10.5 3.67L11.3 2.28",
            "O8 8 1.6"),
    SPEAKER("A6.5 4.5 5 7 -55 110A6 2.5 8.5 11 -55 110", "M1.5 6L4 6L7.5 3L7.5 13L4 10L1.5 10Z"),
    SPEAKER_OFF("M10.5 6L14 10M14 6L10.5 10", "M1.5 6L4 6L7.5 3L7.5 13L4 10L1.5 10Z"),
    PHONE(
            "R4 1.5 8 13 1.25M6.2 9.5L6.3 9.5M8 9.5L8.1 9.5M9.8 9.5L9.9 9.5M6.2 12L6.3 12M8 12L8.1 12",
            "R5.8 3.5 4.4 3.5 0"),
    ROBOT("M5 2.5L11 2.5L13.5 6L13.5 11L11 13.5L5 13.5L2.5 11L2.5 6L5 2.5", "M8 4L10.2 7.2L5.8 7.2Z"),
    FOLLOW("O8 8 4M8 1.5L8 5M8 11L8 14.5M1.5 8L5 8M11 8L14.5 8", ""),
    TRAIL("M2.5 13C3 5 9.5 14 10.5 5.5", "O10.6 3.6 1.8"),
    RAYS("M6 7L13.5 3M6.5 8L14.5 8M6 9L13.5 13", "O3.2 8 1.7"),
    FIT("M2.5 6L2.5 2.5L6 2.5M10 2.5L13.5 2.5L13.5 6M13.5 10L13.5 13.5L10 13.5M6 13.5L2.5 13.5L2.5 10", ""),
    LIST("M6 4.5L13.5 4.5M6 8L13.5 8M6 11.5L13.5 11.5M2.8 4.5L2.9 4.5M2.8 8L2.9 8M2.8 11.5L2.9 11.5", ""),
    WAVE("M1.5 8C2.88 2 3.37 2 4.75 8C6.13 14 6.62 14 8 8C9.38 2 9.87 2 11.25 8C12.63 14 13.12 14 14.5 8", ""),
    TICK("M3.5 8.5L6.5 11.5L12.5 4.5", ""),
    TICKS("M1.5 8.5L4.5 11.5L10 4.5M7.5 10.8L8.2 11.5L14.2 4.5", ""),
    BROADCAST("M8 9L8 14A3.5 2.5 9 9 -45 90A3.5 2.5 9 9 135 90A1 0 14 14 -40 80A1 0 14 14 140 80", "O8 7 1.6"),
    ERASE("M6 3.5L14 3.5L14 12.5L6 12.5L1.8 8L6 3.5M7.8 6L11.8 10M11.8 6L7.8 10", ""),
    BRAKE("", "R3.5 3.5 9 9 0"),
    GRID("M3 2L3 14M2 3L14 3M8 2L8 14M2 8L14 8M13 2L13 14M2 13L14 13", ""),
    POINTER("", "M4 2L4 13L7 10.2L9.2 14.4L11 13.4L8.9 9.5L12.6 9.2Z"),
    WALL("M2.5 12.5L13.5 3.5", "O2.7 12.7 1.7O13.3 3.3 1.7"),
    BOX("R2.5 4 11 8 0M5 9.5L8 6.5M8 9.5L11 6.5", ""),
    HOME("O7 9 4M9.8 6.2L14 2M14 2L10.8 2.3M14 2L13.7 5.2", ""),
    TREADMILL("R1.5 4 13 8 0M4.5 6L6.5 8L4.5 10M9 6L11 8L9 10", ""),
    UNDO("M5.5 2.5L2.5 5.5L5.5 8.5M2.8 5.5L9.5 5.5C14.8 5.5 14.8 13 9.5 13L6 13", ""),
    REDO("M10.5 2.5L13.5 5.5L10.5 8.5M13.2 5.5L6.5 5.5C1.2 5.5 1.2 13 6.5 13L10 13", ""),
    RULER("M1.8 11L11 1.8L14.2 5L5 14.2L1.8 11M4.6 8.2L6 9.6M6.9 5.9L8.9 7.9M9.2 3.6L10.6 5", ""),
    RECORD("", "O8 8 4.5"),
    PERSON("M2.8 14C2.8 10.8 5 9.4 8 9.4C11 9.4 13.2 10.8 13.2 14", "O8 5 3"),
    CALL_OUT("M4 12L12 4M6 4L12 4L12 10", ""),
    CALL_IN("M12 4L4 12M4 6L4 12L10 12", ""),
    CALL_MISSED("M2 5L8 11L14 5M2 9.5L2 5L6.5 5", ""),
    SAVE("M8 2L8 10M4.5 7L8 10.5L11.5 7M2.5 11.5L2.5 13.5L13.5 13.5L13.5 11.5", ""),
    CURSORS("M5 2L5 14M11 2L11 14M5 8L11 8M7 6L5 8L7 10M9 6L11 8L9 10", ""),
    SPECTROGRAM("M2.5 2L2.5 13.5L14 13.5", "R4.5 4 3 1.6 0R8.5 4 4.5 1.6 0R4.5 7.2 5 1.6 0R6.5 10.4 6.5 1.6 0"),
    WORD("M2 3L14 3L14 10.5L8 10.5L5 13.5L5 10.5L2 10.5L2 3M5 5.6L11 5.6M5 8L9 8", ""),
    COMPARE("M1.5 8C2.9 3 4.1 3 5.5 8C6.9 13 8.1 13 9.5 8M6.5 8C7.9 3 9.1 3 10.5 8C11.9 13 13.1 13 14.5 8", ""),
    QUESTION("M5 6C5 2 11 2 11 5.5C11 8 8 8 8 10.5", "O8 13.2 1"),
    BOOK(
            "M8 4C6 2.5 3.5 2.5 2 3.2L2 12.8C3.5 12 6 12 8 13.5C10 12 12.5 12 14 12.8L14 3.2C12.5 2.5 10 2.5 8 4L8 13.5",
            ""),
    EDIT("M2.5 13.5L3.3 10.3L10.8 2.8L13.2 5.2L5.7 12.7L2.5 13.5M9.2 4.4L11.6 6.8", "");

    private static final double SIDE = 16;
    private static final Stroke PEN = new BasicStroke(1.5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);

    private final String lines;
    private final String areas;
    /** Lines and areas, made at the first painting. */
    private Path2D[] paths;

    Symbol(String lines, String areas) {
        this.lines = lines;
        this.areas = areas;
    }

    private synchronized Path2D[] paths() {
        if (paths == null) {
            paths = new Path2D[] {GraphicsCanvas.path(Outline.parse(lines)), GraphicsCanvas.path(Outline.parse(areas))};
        }
        return paths;
    }

    /** An icon with a side of 16 units. */
    public Icon icon() {
        return icon(SIDE);
    }

    /** An icon of another size in units, in its component's colour; it grows with the zoom. */
    public Icon icon(double units) {
        return new Icon() {
            @Override
            public int getIconWidth() {
                return Theme.px(units);
            }

            @Override
            public int getIconHeight() {
                return Theme.px(units);
            }

            @Override
            public void paintIcon(Component c, Graphics graphics, int x, int y) {
                Graphics2D g = Drawing.on(graphics);
                Ink ink = c == null ? Ink.TEXT : Ink.DISABLED;
                g.setColor(c == null || !c.isEnabled() ? Theme.color(ink) : c.getForeground());
                double side = getIconWidth();
                paint(g, x + side / 2, y + side / 2, side);
                g.dispose();
            }
        };
    }

    /** Paints centred on a point in the current colour. @param size side in pixels */
    public void paint(Graphics2D g, double x, double y, double size) {
        Graphics2D copy = (Graphics2D) g.create();
        copy.translate(x - size / 2, y - size / 2);
        copy.scale(size / SIDE, size / SIDE);
        copy.setStroke(PEN);
        copy.draw(paths()[0]);
        copy.fill(paths()[1]);
        copy.dispose();
    }
}
