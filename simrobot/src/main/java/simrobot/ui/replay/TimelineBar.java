package simrobot.ui.replay;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.draw.Canvas;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.ui.Drawing;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.drawing.NumberTexts;
import simrobot.replay.TimelineMarker;
import simrobot.ui.Timeline;

/**
 * The recording from beginning to end, with the current position and the markers, each kind with its mark and row. A
 * click or a drag seeks. The arrows move by 1 s, with Shift by 10 s, the Page keys to the next and the previous marker,
 * Home and End to the beginning and the end.
 */
final class TimelineBar extends PaintedComponent {
    private static final long SECOND_NANOS = 1_000_000_000L;
    private static final double SIDE_UNITS = 12;
    private static final double REACH_UNITS = 5;

    private final TextBundle texts;
    private final LongConsumer seek;
    private Timeline timeline = new Timeline(0, 0, List.of());
    private long position;

    TimelineBar(TextBundle texts, LongConsumer seek) {
        super(AccessibleRole.SLIDER);
        this.texts = texts;
        this.seek = seek;
        setName("timeline");
        makeFocusable();
        setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
        Mouse mouse = new Mouse();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        key("back", KeyEvent.VK_LEFT, 0, () -> position - SECOND_NANOS);
        key("ahead", KeyEvent.VK_RIGHT, 0, () -> position + SECOND_NANOS);
        key("far.back", KeyEvent.VK_LEFT, InputEvent.SHIFT_DOWN_MASK, () -> position - 10 * SECOND_NANOS);
        key("far.ahead", KeyEvent.VK_RIGHT, InputEvent.SHIFT_DOWN_MASK, () -> position + 10 * SECOND_NANOS);
        key("first", KeyEvent.VK_HOME, 0, () -> timeline.firstNanos());
        key("last", KeyEvent.VK_END, 0, () -> timeline.lastNanos());
        key("next", KeyEvent.VK_PAGE_DOWN, 0, () -> timeline.next(position));
        key("previous", KeyEvent.VK_PAGE_UP, 0, () -> timeline.previous(position));
    }

    private void key(String id, int key, int modifiers, LongSupplier to) {
        new UserAction("timeline." + id, "", () -> seek.accept(timeline.clamp(to.getAsLong())))
                .bind(this, JComponent.WHEN_FOCUSED, KeyStroke.getKeyStroke(key, modifiers));
    }

    void show(Timeline newTimeline, long newPosition) {
        if (!newTimeline.equals(timeline) || newPosition != position) {
            change(() -> {
                timeline = newTimeline;
                position = newPosition;
            });
            repaint();
        }
    }

    // ---- places ----------------------------------------------------------------------------------------------------

    private double x(long nanos) {
        double length = Math.max(1, timeline.lastNanos() - timeline.firstNanos());
        double side = Theme.exact(SIDE_UNITS);
        return side + (nanos - timeline.firstNanos()) / length * (getWidth() - 2 * side);
    }

    long nanosAt(double x) {
        double side = Theme.exact(SIDE_UNITS);
        double share = (x - side) / Math.max(1, getWidth() - 2 * side);
        long length = timeline.lastNanos() - timeline.firstNanos();
        return timeline.clamp(timeline.firstNanos() + Math.round(share * length));
    }

    private Optional<TimelineMarker> markerAt(double x) {
        return timeline.markers().stream()
                .filter(marker -> Math.abs(x(marker.timeNanos()) - x) <= Theme.exact(REACH_UNITS))
                .min((a, b) -> Double.compare(Math.abs(x(a.timeNanos()) - x), Math.abs(x(b.timeNanos()) - x)));
    }

    static StatusMark mark(TimelineMarker.Kind kind) {
        return switch (kind) {
            case ORDER -> StatusMark.ARROW;
            case COLLISION -> StatusMark.BURST;
            case REPLY -> StatusMark.DISC;
            case CALL -> StatusMark.DIAMOND;
        };
    }

    static Ink ink(TimelineMarker.Kind kind) {
        return switch (kind) {
            case ORDER -> Ink.ACCENT;
            case COLLISION -> Ink.DANGER;
            case REPLY -> Ink.GOOD;
            case CALL -> Ink.WARNING;
        };
    }

    // ---- painting --------------------------------------------------------------------------------------------------

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Theme.px(400), Theme.px(84));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(200), Theme.px(84));
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        double side = Theme.exact(SIDE_UNITS);
        double track = height - Theme.exact(14);
        double here = x(position);
        for (TimelineMarker.Kind kind : TimelineMarker.Kind.values()) {
            g.setColor(Theme.color(Ink.LINE, 0.6));
            Drawing.horizontal(g, side, width - side, row(kind));
        }
        bar(g, Ink.LINE, width - side, track);
        bar(g, Ink.ACCENT, here, track);
        Canvas canvas = new GraphicsCanvas(g);
        for (TimelineMarker marker : timeline.markers()) {
            mark(marker.kind())
                    .draw(canvas, x(marker.timeNanos()), row(marker.kind()), canvas.px(4.5), ink(marker.kind()));
        }
        canvas.ink(Ink.ACCENT);
        canvas.bar(here, canvas.px(4), canvas.px(1), track - canvas.px(4));
        StatusMark.DISC.draw(canvas, here, track, canvas.px(8), Ink.ACCENT);
    }

    private static void bar(Graphics2D g, Ink ink, double right, double y) {
        double side = Theme.exact(SIDE_UNITS);
        g.setColor(Theme.color(ink));
        g.fill(Drawing.round(side, y - Theme.exact(3), right - side, Theme.exact(6), Theme.exact(3)));
    }

    private double row(TimelineMarker.Kind kind) {
        return Theme.exact(9 + 15 * kind.ordinal());
    }

    @Override
    protected String spoken() {
        return texts.of("timeline.spoken", NumberTexts.clock(position), NumberTexts.clock(timeline.lastNanos()));
    }

    private final class Mouse extends MouseAdapter {
        @Override
        public void mousePressed(MouseEvent event) {
            requestFocusInWindow();
            long to = markerAt(event.getX()).map(TimelineMarker::timeNanos).orElse(nanosAt(event.getX()));
            seek.accept(timeline.clamp(to));
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            seek.accept(nanosAt(event.getX()));
        }

        @Override
        public void mouseMoved(MouseEvent event) {
            setToolTipText(markerAt(event.getX())
                    .map(marker -> NumberTexts.clock(marker.timeNanos()) + "  " + marker.line())
                    .orElse(NumberTexts.clock(nanosAt(event.getX()))));
        }
    }
}
