package simgsm.ui;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.Locale;
import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import simgsm.dtmf.ToneTrace;

/** The tone scope of phone and modem: shows the newest {@link ToneTrace} that it was given. */
public final class ToneScope extends JComponent implements Accessible {
    private final ToneScopePainter painter;
    private ToneTrace trace = ToneTrace.EMPTY;

    public ToneScope(Locale language) {
        painter = new ToneScopePainter(language);
        setName("scope");
    }

    public void show(ToneTrace newTrace) {
        if (newTrace != trace) {
            String before = painter.spoken(trace);
            trace = newTrace;
            String after = painter.spoken(trace);
            if (accessibleContext != null && !before.equals(after)) {
                accessibleContext.firePropertyChange(AccessibleContext.ACCESSIBLE_NAME_PROPERTY, before, after);
            }
            repaint();
        }
    }

    @Override
    public Dimension getPreferredSize() {
        return isPreferredSizeSet() ? super.getPreferredSize() : new Dimension(Theme.px(288), Theme.px(168));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            painter.paint(g, trace, getWidth(), getHeight());
        } finally {
            g.dispose();
        }
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                @Override
                public AccessibleRole getAccessibleRole() {
                    return AccessibleRole.CANVAS;
                }

                @Override
                public String getAccessibleName() {
                    return painter.spoken(trace);
                }
            };
        }
        return accessibleContext;
    }
}
