package simgsm.ui.scope;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.accessibility.AccessibleRole;
import javax.swing.KeyStroke;
import simgsm.dtmf.DtmfKey;
import simgsm.scope.ScopeInstrument;
import simgsm.scope.ScopeInstrument.Picture;
import simgsm.scope.ToneTrace;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/**
 * The picture of a tone scope. The arrows and the mouse move the cursors, with Shift the second one; a click on a key
 * of the matrix answers the question.
 */
public final class ToneScope extends PaintedComponent {
    /** Units. */
    private static final int WIDTH = 288;

    private static final int HEIGHT = 168;
    static final int COMPACT_HEIGHT = 132;
    /** A step of a cursor: one sample on the wave, one spectrum on a spectrogram. */
    private static final double WAVE_STEP_MILLIS = 0.125;

    private static final double SPECTROGRAM_STEP_MILLIS = 10;
    private static final double STEP_HERTZ = 5;
    private static final int LARGE_STEPS = 8;

    private final ScopeInstrument instrument;
    private final ToneScopePainter painter;
    private final Consumer<DtmfKey> guess;
    private boolean compact;
    private int dragged;
    private ShownReceiver receiver = ShownReceiver.MODEM;

    /** A scope without controls. */
    public ToneScope(Locale language) {
        this(language, new ScopeInstrument(), key -> {});
    }

    /** @param guess receives the clicked keys of the matrix */
    ToneScope(Locale language, ScopeInstrument instrument, Consumer<DtmfKey> guess) {
        super(AccessibleRole.CANVAS);
        this.instrument = instrument;
        this.guess = guess;
        painter = new ToneScopePainter(language);
        setName("scope.picture");
        makeFocusable();
        for (int cursor = 0; cursor < 2; cursor++) {
            bind(KeyEvent.VK_LEFT, cursor, -1, 0);
            bind(KeyEvent.VK_RIGHT, cursor, 1, 0);
            bind(KeyEvent.VK_UP, cursor, 0, 1);
            bind(KeyEvent.VK_DOWN, cursor, 0, -1);
        }
        Mouse mouse = new Mouse();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    /** Shift selects the second cursor, Ctrl makes eight steps at once. */
    private void bind(int key, int cursor, int time, int frequency) {
        int shift = cursor == 1 ? InputEvent.SHIFT_DOWN_MASK : 0;
        bind(KeyStroke.getKeyStroke(key, shift), cursor, time, frequency);
        bind(
                KeyStroke.getKeyStroke(key, shift | InputEvent.CTRL_DOWN_MASK),
                cursor,
                time * LARGE_STEPS,
                frequency * LARGE_STEPS);
    }

    private void bind(KeyStroke stroke, int cursor, int time, int frequency) {
        new UserAction("cursor." + stroke, "", () -> move(cursor, time, frequency)).bind(this, WHEN_FOCUSED, stroke);
    }

    private void move(int cursor, int time, int frequency) {
        double step = instrument.picture() == Picture.LEVELS ? WAVE_STEP_MILLIS : SPECTROGRAM_STEP_MILLIS;
        changed(() -> instrument.cursors().move(cursor, time * step, frequency * STEP_HERTZ));
    }

    /** Runs a change of the instrument and shows it. */
    void changed(Runnable change) {
        change(change);
        repaint();
    }

    public void show(ToneTrace trace) {
        String before = spoken();
        if (instrument.show(trace)) {
            if (!before.equals(spoken())) {
                change(() -> {});
            }
            repaint();
        }
    }

    /** Selects the receiver of the levels, limits and last key. */
    void show(ShownReceiver newReceiver) {
        changed(() -> receiver = newReceiver);
    }

    /** A preferred height of 132 units instead of 168. */
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
        painter.paint(g, instrument, receiver.of(instrument.trace()), width, height);
    }

    @Override
    protected String spoken() {
        return painter.spoken(instrument, receiver.of(instrument.trace()));
    }

    private final class Mouse extends MouseAdapter {
        @Override
        public void mousePressed(MouseEvent event) {
            requestFocusInWindow();
            Optional<DtmfKey> key = keyAt(event.getX(), event.getY());
            if (key.isPresent()) {
                guess.accept(key.get());
            } else if (instrument.hasCursors()) {
                dragged = instrument.cursors().nearest(millis(event), hertz(event));
                mouseDragged(event);
            }
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            if (instrument.hasCursors()) {
                changed(() -> instrument.cursors().put(dragged, millis(event), hertz(event)));
            }
        }

        private double millis(MouseEvent event) {
            Rectangle2D area = painter.area(instrument, getWidth(), getHeight());
            double span = instrument.picture() == Picture.LEVELS
                    ? ScopeInstrument.WAVE_MILLIS
                    : ScopeInstrument.SPECTROGRAM_MILLIS;
            return (event.getX() - area.getX()) / area.getWidth() * span;
        }

        private double hertz(MouseEvent event) {
            Rectangle2D area = painter.area(instrument, getWidth(), getHeight());
            return ScopeInstrument.LEAST_HERTZ
                    + (area.getMaxY() - event.getY())
                            / area.getHeight()
                            * (ScopeInstrument.MOST_HERTZ - ScopeInstrument.LEAST_HERTZ);
        }

        private Optional<DtmfKey> keyAt(int x, int y) {
            Rectangle2D box = painter.keys(getWidth(), getHeight());
            if (instrument.picture() != Picture.LEVELS || !box.contains(x, y)) {
                return Optional.empty();
            }
            int column = (int) ((x - box.getX()) / box.getWidth() * 4);
            int row = (int) ((y - box.getY()) / box.getHeight() * 4);
            return Optional.of(DtmfKey.at(row, column));
        }
    }
}
