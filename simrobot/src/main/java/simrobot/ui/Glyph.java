package simrobot.ui;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import javax.swing.Icon;
import simgsm.ui.CodeIcon;
import simgsm.ui.Theme;

/** The two pictograms that only this window needs. */
enum Glyph {
    BRAKE,
    GRID;

    Icon icon() {
        return new CodeIcon(CodeIcon.SIDE) {
            @Override
            protected void draw(Graphics2D g) {
                Glyph.this.draw(g);
            }
        };
    }

    private void draw(Graphics2D g) {
        if (this == BRAKE) {
            g.fill(new Rectangle2D.Double(3.5, 3.5, 9, 9));
            return;
        }
        g.setStroke(Theme.stroke(1.3 / Theme.zoom()));
        for (double at : new double[] {3, 8, 13}) {
            g.draw(new Line2D.Double(at, 2, at, 14));
            g.draw(new Line2D.Double(2, at, 14, at));
        }
    }
}
