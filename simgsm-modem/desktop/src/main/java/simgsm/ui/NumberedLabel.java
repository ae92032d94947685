package simgsm.ui;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.accessibility.AccessibleRole;
import simgsm.draw.Ink;

/** A small numbered token with its word: a reply tone, a count. The number stands on the ink, the word beside it. */
public final class NumberedLabel extends SpokenComponent {
    private final String number;
    private final String word;
    private final Ink ink;

    /** @param word may be empty, then only the number is shown */
    public NumberedLabel(String number, String word, Ink ink) {
        super(AccessibleRole.LABEL);
        this.number = number;
        this.word = word;
        this.ink = ink;
    }

    /** The colour family in which the suite shows a reply tone, 1 to 8. */
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
        return new Dimension(width, Theme.px(24));
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }

    @Override
    public Dimension getMaximumSize() {
        return getPreferredSize();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            paint(g, 0, (getHeight() - Theme.exact(24)) / 2, getWidth(), Theme.exact(24));
        } finally {
            g.dispose();
        }
    }

    private void paint(Graphics2D g, double x, double y, double width, double height) {
        double radius = Theme.exact(Theme.CONTROL_RADIUS);
        var outline = Drawing.round(x + 0.5, y + 0.5, width - 1, height - 1, radius);
        double numberWidth = Drawing.width(Theme.monoStrong(), number) + Theme.exact(14);
        g.setColor(Theme.color(Ink.CARD));
        g.fill(outline);
        g.setColor(Theme.color(ink));
        g.setStroke(Theme.hairline());
        g.draw(outline);
        g.fill(Drawing.round(x, y, Math.min(width, numberWidth), height, radius));
        g.setColor(Theme.color(Ink.ON_SIGNAL));
        Drawing.centred(g, number, Theme.monoStrong(), x + numberWidth / 2, y + height / 2);
        if (!word.isEmpty()) {
            g.setFont(Theme.base());
            g.setColor(Theme.color(Ink.TEXT));
            double room = width - numberWidth - Theme.exact(12);
            String fitted = Drawing.fitted(Theme.base(), word, room);
            double cap = Drawing.capHeight(g, Theme.base());
            g.drawString(fitted, (float) (x + numberWidth + Theme.exact(8)), (float) (y + height / 2 + cap / 2));
        }
    }

    @Override
    protected String spoken() {
        return (number + " " + word).strip();
    }
}
