package simgsm.center.ui.ladder;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Graphics;
import java.awt.geom.Path2D;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.ListCellRenderer;
import simgsm.center.msc.LadderEntry;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;

/** Paints a rung: the time, the lifelines, the arrow with the message's name on it, the protocol's tag. */
final class LadderCell extends JLabel implements ListCellRenderer<LadderRow> {
    static final double HEIGHT_UNITS = 30;
    private static final double HEAD_UNITS = 6;

    private Lifelines lifelines = Lifelines.NONE;
    private LadderRow row;
    private boolean isSelected;
    private boolean isFocused;

    void show(Lifelines newLifelines) {
        lifelines = newLifelines;
    }

    @Override
    public Component getListCellRendererComponent(
            JList<? extends LadderRow> list, LadderRow value, int index, boolean selected, boolean focused) {
        row = value;
        isSelected = selected;
        isFocused = focused;
        setText(value.toString());
        return this;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(lifelines.leastWidth(), Theme.px(HEIGHT_UNITS));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            g.setColor(Theme.color(isSelected ? Ink.ACCENT_WASH : Ink.CARD));
            g.fillRect(0, 0, getWidth(), getHeight());
            paintLines(g);
            paintTime(g);
            paintArrow(g, row.entry());
            if (isFocused) {
                g.setColor(Theme.color(Ink.ACCENT));
                g.setStroke(Theme.hairline());
                g.draw(Drawing.round(1, 1, getWidth() - 3, getHeight() - 3, Theme.exact(Theme.HALF)));
            }
        } finally {
            g.dispose();
        }
    }

    private void paintLines(Graphics2D g) {
        for (String name : lifelines.names()) {
            g.setColor(Theme.color(name.equals(LadderEntry.CENTER) ? Ink.ACCENT : Ink.CONTROL_LINE));
            Drawing.vertical(g, lifelines.x(name, getWidth()), 0, getHeight());
        }
    }

    private void paintTime(Graphics2D g) {
        g.setFont(Theme.monoSmall());
        g.setColor(Theme.color(Ink.QUIET));
        double cap = Drawing.capHeight(g, Theme.monoSmall());
        g.drawString(row.clock(), Theme.exact(10), (float) ((getHeight() + cap) / 2));
        g.setFont(Theme.small());
        g.setColor(Theme.color(Protocol.of(row.entry()).ink()));
        Drawing.rightAligned(g, Protocol.of(row.entry()).tag(), getWidth() - Theme.exact(10), (getHeight() + cap) / 2);
    }

    /**
     * A name that is longer than its arrow extends over the neighbouring columns. Messages of a terminal without a lifeline
     * are drawn at the centre's line, with the terminal's number before the name.
     */
    private void paintArrow(Graphics2D g, LadderEntry entry) {
        int width = getWidth();
        double from = lifelines.x(entry.from(), width);
        double to = lifelines.x(entry.to(), width);
        double center = lifelines.x(LadderEntry.CENTER, width);
        boolean hasLine = from >= 0 && to >= 0;
        String name = hasLine ? entry.name() : row.terminal() + " " + entry.name();
        double gap = lifelines.gap(width);
        double start = from >= 0 ? from : center - gap / 2;
        double end = to >= 0 ? to : center + gap / 2;
        double y = getHeight() - Theme.exact(8);
        g.setColor(Theme.color(Protocol.of(entry).ink()));
        g.setStroke(Theme.stroke(1.4));
        double tip = end - Math.signum(end - start) * Theme.exact(2);
        Drawing.line(g, start, y, tip - Math.signum(end - start) * Theme.exact(HEAD_UNITS - 1), y);
        paintHead(g, tip, y, Math.signum(end - start));
        double room = Math.abs(end - start) - Theme.exact(8);
        Font font = Drawing.width(Theme.base(), name) <= room ? Theme.base() : Theme.small();
        double left = Theme.exact(Lifelines.TIME_UNITS);
        double right = width - Theme.exact(Lifelines.TAG_UNITS);
        String fitted = Drawing.fitted(font, name, right - left);
        g.setFont(font);
        double textWidth = Drawing.width(font, fitted);
        double x = Math.max(left, Math.min(right - textWidth, (start + end - textWidth) / 2));
        paintPlate(g, x, textWidth);
        g.setColor(Theme.color(Ink.TEXT));
        g.drawString(fitted, (float) x, (float) (y - Theme.exact(6)));
    }

    /** Hides the lifelines behind the name. */
    private void paintPlate(Graphics2D g, double x, double width) {
        g.setColor(Theme.color(isSelected ? Ink.ACCENT_WASH : Ink.CARD));
        Drawing.fillCrisp(g, x - Theme.exact(3), Theme.exact(4), width + Theme.exact(6), getHeight() - Theme.exact(15));
    }

    private static void paintHead(Graphics2D g, double x, double y, double sign) {
        double length = Theme.exact(HEAD_UNITS);
        Path2D head = new Path2D.Double();
        head.moveTo(x, y);
        head.lineTo(x - sign * length * 1.4, y - length * 0.7);
        head.lineTo(x - sign * length * 1.4, y + length * 0.7);
        head.closePath();
        g.fill(head);
    }
}
