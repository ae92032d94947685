package simrobot.ui.replay;

import java.awt.BorderLayout;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.ComponentNames;
import simgsm.ui.Lamp;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.drawing.NumberTexts;
import simrobot.replay.TimelineMarker;
import simrobot.ui.CompactButtons;
import simrobot.ui.OperatorActions;
import simrobot.ui.TextLine;
import simrobot.ui.Timeline;

/** A recording that is played: its timeline, and buttons from marker to marker. It takes the telephone's place. */
public final class TimelinePanel extends JPanel {
    private final TimelineBar bar;
    private final OperatorActions operator;
    private final TextLine time = new TextLine("timeline.time", Theme::monoStrong, Ink.TEXT);
    private final JPanel row;
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
        row = Arrange.row(
                Theme.HALF,
                button("previous", Symbol.LEFT, KeyEvent.VK_LEFT, texts, () -> timeline.previous(position)),
                button("next", Symbol.RIGHT, KeyEvent.VK_RIGHT, texts, () -> timeline.next(position)),
                time,
                Arrange.spring(),
                legend);
        CompactButtons.buttonsIn(row);
        add(new Card(texts.of("timeline.title"), Arrange.column(Theme.GRID, bar, row)));
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

    private JButton button(String id, Symbol symbol, int key, TextBundle texts, java.util.function.LongSupplier where) {
        String name = texts.of(id.equals("next") ? "timeline.next" : "timeline.previous");
        UserAction act =
                new UserAction("timeline.to." + id, name, () -> operator.seek(where.getAsLong())).with(symbol.icon());
        act.bindInWindow(this, KeyStroke.getKeyStroke(key, InputEvent.ALT_DOWN_MASK | InputEvent.CTRL_DOWN_MASK));
        JButton button = new JButton(act.described(name + "  (Ctrl+Alt+" + KeyEvent.getKeyText(key) + ")"));
        button.setHideActionText(true);
        return ComponentNames.name(button, act.id(), name);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (row != null) {
            CompactButtons.buttonsIn(row);
        }
    }

    public void show(Timeline newest, long nanos) {
        timeline = newest;
        position = nanos;
        bar.show(newest, nanos);
        time.show(NumberTexts.clock(nanos) + " / " + NumberTexts.clock(newest.lastNanos()));
    }
}
