package simrobot.ui;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.util.List;
import java.util.function.Supplier;
import javax.accessibility.AccessibleRole;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;

/** A text in one row or two, with an ellipsis if it does not fit. */
public final class TextLine extends PaintedComponent {
    private final Supplier<Font> font;
    private String text = "";
    private Ink ink;
    private int rows = 1;
    private boolean shrinking;
    private boolean isNumber;

    public TextLine(String name, Supplier<Font> font, Ink ink) {
        super(AccessibleRole.LABEL);
        setName(name);
        this.font = font;
        this.ink = ink;
    }

    /** Sets two rows; a text too wide for one breaks at a blank. */
    public TextLine overTwoRows() {
        rows = 2;
        return this;
    }

    /** Truncates at the front, because numbers differ in their last digits. */
    public TextLine ofDigits() {
        isNumber = true;
        return this;
    }

    /** Prefers a width of 24 units for any text; the tool tip has the whole text. */
    public TextLine shrinking() {
        shrinking = true;
        return this;
    }

    public void show(String newText) {
        show(newText, ink);
    }

    public void show(String newText, Ink newInk) {
        boolean changed = newInk != ink || !newText.equals(text);
        change(() -> text = newText);
        ink = newInk;
        if (changed) {
            setToolTipText(text.isEmpty() ? null : text);
            revalidate();
            repaint();
        }
    }

    @Override
    protected String spoken() {
        return text;
    }

    @Override
    public Dimension getPreferredSize() {
        Font face = font.get();
        int width = shrinking ? Theme.px(24) : Drawing.width(face, text) + 1;
        return new Dimension(width, rows * rowHeight());
    }

    private int rowHeight() {
        return getFontMetrics(font.get()).getHeight();
    }

    /** The height of the text's rows at a width in pixels. */
    public int heightFor(int width) {
        return Math.max(1, Drawing.wrapped(font.get(), text, width, rows).size()) * rowHeight();
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(24), getPreferredSize().height);
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        Font face = font.get();
        g.setFont(face);
        g.setColor(Theme.color(ink));
        int fit = Math.max(1, Math.min(rows, (int) (height / rowHeight())));
        double row = height / fit;
        double base = row / 2 + Drawing.capHeight(g, face) / 2;
        List<String> lines = Drawing.wrapped(face, text, width, fit);
        if (lines.size() <= 1) {
            String fitted = isNumber ? Drawing.fittedEnd(face, text, width) : Drawing.fitted(face, text, width);
            g.drawString(fitted, 0, (float) (height - row + base));
        }
        for (int i = 0; i < lines.size() && lines.size() > 1; i++) {
            g.drawString(lines.get(i), 0, (float) (i * row + base));
        }
    }
}
