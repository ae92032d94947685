package simgsm.ui;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.Locale;
import javax.accessibility.AccessibleRole;
import simgsm.dtmf.ToneTrace;

/** The tone scope of phone and modem: shows the newest {@link ToneTrace} that it was given. */
public final class ToneScope extends SpokenComponent {
    private final ToneScopePainter painter;
    private ToneTrace trace = ToneTrace.EMPTY;

    public ToneScope(Locale language) {
        super(AccessibleRole.CANVAS);
        painter = new ToneScopePainter(language);
        setName("scope.picture");
    }

    public void show(ToneTrace newTrace) {
        if (newTrace != trace) {
            String before = spoken();
            trace = newTrace;
            tellSpoken(before, spoken());
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
    protected String spoken() {
        return painter.spoken(trace);
    }
}
