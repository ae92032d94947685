package simrobot.ui;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.function.Supplier;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;

/** A line of text that takes what room there is, or two, and ends in an ellipsis when that is too little. */
public final class TextLine extends PaintedComponent {
    private final Supplier<Font> font;
    private String text = "";
    private Ink ink;
    private int rows = 1;
    private boolean modest;

    public TextLine(String name, Supplier<Font> font, Ink ink) {
        super(name);
        this.font = font;
        this.ink = ink;
    }

    /** Keeps room for a second row, into which it breaks at a blank. */
    public TextLine overTwoRows() {
        rows = 2;
        return this;
    }

    /** It takes what room there is, and asks for none; what does not fit is in its tool tip. */
    public TextLine modest() {
        modest = true;
        return this;
    }

    public void show(String newText) {
        show(newText, ink);
    }

    public void show(String newText, Ink newInk) {
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
    protected Dimension preferred() {
        Font face = font.get();
        int width = modest ? Theme.px(24) : Drawing.width(face, text) + 1;
        return new Dimension(width, rows * getFontMetrics(face).getHeight());
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(24), preferred().height);
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        Font face = font.get();
        g.setFont(face);
        g.setColor(Theme.color(ink));
        int end = rows == 1 ? text.length() : firstRow(face, text, width);
        String rest = text.substring(end).strip();
        double row = height / rows;
        double base = row / 2 + Drawing.capHeight(g, face) / 2;
        if (rest.isEmpty()) {
            g.drawString(Drawing.fitted(face, text, width), 0, (float) (height - row + base));
        } else {
            g.drawString(Drawing.fitted(face, text.substring(0, end), width), 0, (float) base);
            g.drawString(Drawing.fitted(face, rest, width), 0, (float) (row + base));
        }
    }

    /** How much of a text stands in the first row: all, or as many whole words as fit, one at least. */
    static int firstRow(Font face, String text, double width) {
        int end = text.length();
        while (Drawing.width(face, text.substring(0, end)) > width) {
            int blank = text.lastIndexOf(' ', end - 1);
            if (blank <= 0) {
                return end;
            }
            end = blank;
        }
        return end;
    }
}
