package simrobot.ui;

import java.awt.Dimension;
import java.awt.Graphics2D;
import javax.accessibility.AccessibleRole;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;

/** A row with a name at the left and a number with its unit at the right. */
public final class ValueRow extends PaintedComponent {
    private final String label;
    private final String unit;
    private String value = "";

    public ValueRow(String name, String label, String unit) {
        super(AccessibleRole.LABEL);
        setName(name);
        this.label = label;
        this.unit = unit;
        show("\u2013");
    }

    public void show(String newValue) {
        change(() -> value = newValue);
    }

    @Override
    protected String spoken() {
        return label + ": " + value + " " + unit;
    }

    @Override
    public Dimension getPreferredSize() {
        int width = Drawing.width(Theme.base(), label)
                + Drawing.width(Theme.mono(), "-00.000 ")
                + Drawing.width(Theme.small(), unit)
                + Theme.px(8);
        return new Dimension(width, Theme.px(19));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        double base = height / 2 + Drawing.capHeight(g, Theme.base()) / 2;
        g.setFont(Theme.base());
        g.setColor(Theme.color(Ink.QUIET));
        g.drawString(label, 0, (float) base);
        double unitWidth = Drawing.width(Theme.small(), "m/s");
        g.setFont(Theme.small());
        g.drawString(unit, (float) (width - unitWidth), (float) base);
        g.setFont(Theme.monoStrong());
        g.setColor(Theme.color(Ink.TEXT));
        Drawing.rightAligned(g, value, width - unitWidth - Theme.exact(5), base);
    }
}
