package simgsm.ui.scope;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.util.Locale;
import javax.accessibility.AccessibleRole;
import simgsm.dtmf.ToneTrace;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;

/** The picture of a {@link ToneTrace}. */
public final class ToneScope extends PaintedComponent {
    /** In units. */
    private static final int WIDTH = 288;

    private static final int HEIGHT = 168;
    private static final int COMPACT_HEIGHT = 132;

    private final ToneScopePainter painter;
    private boolean compact;
    private ToneTrace trace = ToneTrace.EMPTY;
    private ShownReceiver receiver = ShownReceiver.MODEM;

    public ToneScope(Locale language) {
        super(AccessibleRole.CANVAS);
        painter = new ToneScopePainter(language);
        setName("scope.picture");
    }

    public void show(ToneTrace newTrace) {
        if (newTrace != trace) {
            change(() -> trace = newTrace);
            repaint();
        }
    }

    /** Selects the receiver whose levels, limits and last key are shown. */
    void show(ShownReceiver newReceiver) {
        change(() -> receiver = newReceiver);
        repaint();
    }

    /** A preferred height of 132 units in place of 168. */
    void setCompact(boolean wanted) {
        if (compact != wanted) {
            compact = wanted;
            revalidate();
        }
    }

    @Override
    public Dimension getPreferredSize() {
        return isPreferredSizeSet()
                ? super.getPreferredSize()
                : new Dimension(Theme.px(WIDTH), Theme.px(compact ? COMPACT_HEIGHT : HEIGHT));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        painter.paint(g, trace, receiver.of(trace), width, height);
    }

    @Override
    protected String spoken() {
        return painter.spoken(receiver.of(trace));
    }
}
