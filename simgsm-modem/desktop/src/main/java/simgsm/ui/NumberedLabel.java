package simgsm.ui;

import java.awt.Dimension;
import java.awt.Graphics2D;
import javax.accessibility.AccessibleRole;
import simgsm.draw.Ink;

/** A number on a coloured background, followed by a word: a reply tone with its meaning. */
public final class NumberedLabel extends PaintedComponent {
    private static final double HEIGHT_UNITS = 24;

    private final String number;
    private final String word;
    private final Ink ink;

    /** @param word if empty, only the number is shown */
    public NumberedLabel(String number, String word, Ink ink) {
        super(AccessibleRole.LABEL);
        this.number = number;
        this.word = word;
        this.ink = ink;
    }

    /** The colour of a reply tone, 1 to 8. */
    public static Ink inkOfTone(char tone) {
        return switch (tone) {
            case '1', '3' -> Ink.GOOD;
            case '6' -> Ink.ACCENT;
            case '5', '8' -> Ink.WARNING;
            case '2', '4', '7' -> Ink.DANGER;
            default -> Ink.QUIET;
        };
    }

    @Override
    public Dimension getPreferredSize() {
        int width = Drawing.width(Theme.monoStrong(), number) + Theme.px(14);
        if (!word.isEmpty()) {
            width += Drawing.width(Theme.base(), word) + Theme.px(18);
        }
        return new Dimension(width, Theme.px(HEIGHT_UNITS));
    }

    @Override
    public Dimension getMaximumSize() {
        return getPreferredSize();
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        double radius = Theme.exact(Theme.CONTROL_RADIUS);
        double tall = Theme.exact(HEIGHT_UNITS);
        double top = (height - tall) / 2;
        double middle = height / 2;
        var outline = Drawing.round(0.5, top + 0.5, width - 1, tall - 1, radius);
        double numberWidth = Drawing.width(Theme.monoStrong(), number) + Theme.exact(14);
        g.setColor(Theme.color(Ink.CARD));
        g.fill(outline);
        g.setColor(Theme.color(ink));
        g.setStroke(Theme.hairline());
        g.draw(outline);
        g.fill(Drawing.round(0, top, Math.min(width, numberWidth), tall, radius));
        g.setColor(Theme.color(Ink.ON_SIGNAL));
        Drawing.centred(g, number, Theme.monoStrong(), numberWidth / 2, middle);
        if (!word.isEmpty()) {
            g.setFont(Theme.base());
            g.setColor(Theme.color(Ink.TEXT));
            double room = width - numberWidth - Theme.exact(12);
            String fitted = Drawing.fitted(Theme.base(), word, room);
            double cap = Drawing.capHeight(g, Theme.base());
            g.drawString(fitted, (float) (numberWidth + Theme.exact(8)), (float) (middle + cap / 2));
        }
    }

    @Override
    protected String spoken() {
        return (number + " " + word).strip();
    }
}
