package simrobot.ui.replay;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.function.LongConsumer;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.ui.Drawing;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.SpokenComponent;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.replay.TimelineMarker;
import simrobot.ui.Timeline;
import simrobot.ui.floor.WorldView;

/**
 * The recording from its beginning to its end, with the present position and the markers, each kind in a shape and a row of
 * its own. A click or a drag seeks; arrows go a second (with Shift ten), Page keys from marker to marker, Home and End.
 */
final class TimelineBar extends SpokenComponent {
    private static final long SECOND_NANOS = 1_000_000_000L;
    private static final double SIDE_UNITS = 12;
    private static final double REACH_UNITS = 5;

    private final TextBundle texts;
    private final LongConsumer seek;
    private Timeline timeline = new Timeline(0, 0, java.util.List.of());
    private long position;

    TimelineBar(TextBundle texts, LongConsumer seek) {
        super(AccessibleRole.SLIDER);
        this.texts = texts;
        this.seek = seek;
        setName("timeline");
        setFocusable(true);
        setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
        Hand hand = new Hand();
        addMouseListener(hand);
        addMouseMotionListener(hand);
        addFocusListener(hand);
        key("back", KeyEvent.VK_LEFT, 0, () -> position - SECOND_NANOS);
        key("ahead", KeyEvent.VK_RIGHT, 0, () -> position + SECOND_NANOS);
        key("far.back", KeyEvent.VK_LEFT, InputEvent.SHIFT_DOWN_MASK, () -> position - 10 * SECOND_NANOS);
        key("far.ahead", KeyEvent.VK_RIGHT, InputEvent.SHIFT_DOWN_MASK, () -> position + 10 * SECOND_NANOS);
        key("first", KeyEvent.VK_HOME, 0, () -> timeline.firstNanos());
        key("last", KeyEvent.VK_END, 0, () -> timeline.lastNanos());
        key("next", KeyEvent.VK_PAGE_DOWN, 0, () -> timeline.next(position));
        key("previous", KeyEvent.VK_PAGE_UP, 0, () -> timeline.previous(position));
    }

    private void key(String id, int key, int modifiers, java.util.function.LongSupplier to) {
        new UserAction("timeline." + id, "", () -> seek.accept(timeline.clamp(to.getAsLong())))
                .bind(this, JComponent.WHEN_FOCUSED, KeyStroke.getKeyStroke(key, modifiers));
    }

    void show(Timeline newTimeline, long newPosition) {
        if (!newTimeline.equals(timeline) || newPosition != position) {
            String before = spoken();
            timeline = newTimeline;
            position = newPosition;
            tellSpoken(before, spoken());
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
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            double side = Theme.exact(SIDE_UNITS);
            double track = getHeight() - Theme.exact(14);
            for (TimelineMarker.Kind kind : TimelineMarker.Kind.values()) {
                g.setColor(Theme.color(Ink.LINE, 0.6));
                Drawing.horizontal(g, side, getWidth() - side, row(kind));
            }
            g.setColor(Theme.color(Ink.LINE));
            g.fill(Drawing.round(side, track - Theme.exact(3), getWidth() - 2 * side, Theme.exact(6), Theme.exact(3)));
            double here = x(position);
            g.setColor(Theme.color(Ink.ACCENT));
            g.fill(Drawing.round(side, track - Theme.exact(3), here - side, Theme.exact(6), Theme.exact(3)));
            for (TimelineMarker marker : timeline.markers()) {
                mark(marker.kind())
                        .draw(
                                new GraphicsCanvas(g),
                                x(marker.timeNanos()),
                                row(marker.kind()),
                                Theme.exact(4.5),
                                ink(marker.kind()));
            }
            g.setColor(Theme.color(Ink.ACCENT));
            Drawing.vertical(g, here, Theme.exact(4), track);
            StatusMark.DISC.draw(new GraphicsCanvas(g), here, track, Theme.exact(8), Ink.ACCENT);
            if (isFocusOwner()) {
                g.setStroke(Theme.stroke(1.6));
                g.draw(Drawing.round(1, 1, getWidth() - 2, getHeight() - 2, Theme.exact(4)));
            }
        } finally {
            g.dispose();
        }
    }

    private double row(TimelineMarker.Kind kind) {
        return Theme.exact(9 + 15 * kind.ordinal());
    }

    @Override
    protected String spoken() {
        return texts.of("timeline.spoken", WorldView.clockText(position), WorldView.clockText(timeline.lastNanos()));
    }

    private final class Hand extends MouseAdapter implements FocusListener {
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
                    .map(marker -> WorldView.clockText(marker.timeNanos()) + "  " + marker.line())
                    .orElse(WorldView.clockText(nanosAt(event.getX()))));
        }

        @Override
        public void focusGained(FocusEvent event) {
            repaint();
        }

        @Override
        public void focusLost(FocusEvent event) {
            repaint();
        }
    }
}
