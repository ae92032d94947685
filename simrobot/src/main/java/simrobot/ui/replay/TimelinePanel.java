package simrobot.ui.replay;

import java.awt.BorderLayout;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.function.LongSupplier;
import javax.swing.JButton;
import javax.swing.JPanel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.Lamp;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.drawing.NumberTexts;
import simrobot.replay.TimelineMarker;
import simrobot.ui.OperatorActions;
import simrobot.ui.SplitRow;
import simrobot.ui.TextLine;
import simrobot.ui.Timeline;
import simrobot.ui.ToolButtons;

/** The timeline of a recording, with buttons to the next and the previous marker; modem and VeriCommand are hidden. */
public final class TimelinePanel extends JPanel {
    private final TimelineBar bar;
    private final OperatorActions operator;
    private final TextLine time = new TextLine("timeline.time", Theme::monoStrong, Ink.TEXT);
    private Timeline timeline;
    private long position;

    public TimelinePanel(TextBundle texts, OperatorActions operator) {
        super(new BorderLayout());
        this.operator = operator;
        setOpaque(false);
        bar = new TimelineBar(texts, operator::seek);
        JPanel legend = Arrange.row(16);
        for (TimelineMarker.Kind kind : TimelineMarker.Kind.values()) {
            Lamp lamp = new Lamp(texts.of("timeline.legend"));
            lamp.show(TimelineBar.mark(kind), TimelineBar.ink(kind), word(texts, kind));
            legend.add(lamp);
        }
        JPanel steps = Arrange.row(
                Theme.HALF,
                button(
                        "previous",
                        Symbol.LEFT,
                        KeyEvent.VK_LEFT,
                        texts.of("timeline.previous"),
                        () -> timeline.previous(position)),
                button(
                        "next",
                        Symbol.RIGHT,
                        KeyEvent.VK_RIGHT,
                        texts.of("timeline.next"),
                        () -> timeline.next(position)),
                time);
        add(new Card(texts.of("timeline.title"), Arrange.column(Theme.GRID, bar, new SplitRow(steps, legend))));
        setVisible(false);
    }

    private static String word(TextBundle texts, TimelineMarker.Kind kind) {
        return switch (kind) {
            case ORDER -> texts.of("timeline.order");
            case COLLISION -> texts.of("timeline.collision");
            case REPLY -> texts.of("timeline.reply");
            case CALL -> texts.of("timeline.call");
        };
    }

    private JButton button(String id, Symbol symbol, int key, String name, LongSupplier nanos) {
        UserAction action = new UserAction("timeline.to." + id, name, () -> operator.seek(nanos.getAsLong()))
                .with(symbol.icon())
                .onKey(this, key, InputEvent.ALT_DOWN_MASK | InputEvent.CTRL_DOWN_MASK);
        return ToolButtons.icon(new JButton(), action);
    }

    public void show(Timeline newest, long nanos) {
        timeline = newest;
        position = nanos;
        bar.show(newest, nanos);
        time.show(NumberTexts.clock(nanos) + " / " + NumberTexts.clock(newest.lastNanos()));
    }
}
