package simrobot.ui;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.function.Supplier;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;
import simgsm.ui.Theme.Ink;

/** One line of text that takes what room there is and ends in an ellipsis when that is too little. */
final class Line extends Painted {
    private final Supplier<Font> font;
    private String text = "";
    private Ink ink;

    Line(String name, Supplier<Font> font, Ink ink) {
        super(name);
        this.font = font;
        this.ink = ink;
    }

    void show(String newText) {
        show(newText, ink);
    }

    void show(String newText, Ink newInk) {
        boolean changed = newInk != ink || !newText.equals(text);
        text = newText;
        ink = newInk;
        say(text);
        if (changed) {
            setToolTipText(text.isEmpty() ? null : text);
            revalidate();
            repaint();
        }
    }

    String text() {
        return text;
    }

    @Override
    Dimension preferred() {
        Font face = font.get();
        return new Dimension(Drawing.width(face, text) + 1, getFontMetrics(face).getHeight());
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(24), preferred().height);
    }

    @Override
    void paint(Graphics2D g, double width, double height) {
        Font face = font.get();
        g.setFont(face);
        g.setColor(ink.color());
        g.drawString(Drawing.fitted(face, text, width), 0, (float) (height / 2 + Drawing.capHeight(g, face) / 2));
    }
}
