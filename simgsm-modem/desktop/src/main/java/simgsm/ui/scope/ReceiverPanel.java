package simgsm.ui.scope;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.ButtonGroup;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import simgsm.console.TextBundle;
import simgsm.scope.ToneTrace;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/**
 * Both receivers of the same samples, each with a button and its candidates. The button selects the receiver of the
 * levels, limits and last key in the scope.
 */
final class ReceiverPanel extends JPanel {
    private final Map<ShownReceiver, CandidateLane> lanes = new EnumMap<>(ShownReceiver.class);
    private final Map<ShownReceiver, JPanel> rows = new EnumMap<>(ShownReceiver.class);
    private final TextBundle texts;
    private final boolean choosable;
    private ShownReceiver selected = ShownReceiver.MODEM;
    private boolean compact;
    private boolean hiding;

    /**
     * @param choosable if false, only the candidates of the receiver of phone and modem are shown
     * @param chosen receives each selected receiver
     */
    ReceiverPanel(Locale language, boolean choosable, Consumer<ShownReceiver> chosen) {
        super(new BorderLayout());
        this.choosable = choosable;
        texts = DesktopTexts.in(language);
        setOpaque(false);
        Theme.styled(this, panel -> panel.setBorder(Theme.padding(4, 0, 0, 0)));
        ButtonGroup one = new ButtonGroup();
        for (ShownReceiver receiver : ShownReceiver.values()) {
            JToggleButton button = button(receiver, chosen);
            button.setSelected(receiver == selected);
            button.setVisible(choosable);
            one.add(button);
            CandidateLane lane = new CandidateLane(language, receiver);
            lanes.put(receiver, lane);
            rows.put(receiver, Arrange.row(Theme.GRID, button, Arrange.growing(lane)));
        }
        add(Arrange.column(4, rows.get(ShownReceiver.MODEM), rows.get(ShownReceiver.CLASSIC)), BorderLayout.CENTER);
        arrange();
    }

    private JToggleButton button(ShownReceiver receiver, Consumer<ShownReceiver> chosen) {
        JToggleButton button = new JToggleButton(new UserAction(receiver.key, texts.of(receiver.key), () -> {
            selected = receiver;
            arrange();
            chosen.accept(receiver);
        }));
        button.setToolTipText(texts.of(receiver.key + ".tip"));
        ComponentNames.name(button, receiver.key, texts.of(receiver.key));
        return Theme.styled(button, it -> {
            it.setFont(Theme.small());
            it.setBorder(Theme.padding(0, 4, 0, 4));
            it.setPreferredSize(new Dimension(longestName() + Theme.px(24), Theme.px(38)));
        });
    }

    private int longestName() {
        int longest = 0;
        for (ShownReceiver receiver : ShownReceiver.values()) {
            longest = Math.max(longest, Drawing.width(Theme.small(), texts.of(receiver.key)));
        }
        return longest;
    }

    void show(ToneTrace trace) {
        lanes.forEach((receiver, lane) -> lane.show(receiver.of(trace)));
    }

    /** Compact: only the selected receiver's row. */
    void setCompact(boolean nowCompact) {
        compact = nowCompact;
        arrange();
    }

    /** Hides all findings, which reveal the key. */
    void setHiding(boolean nowHiding) {
        hiding = nowHiding;
        arrange();
    }

    private void arrange() {
        rows.forEach((receiver, row) -> row.setVisible(!hiding && (choosable && !compact || receiver == selected)));
    }
}
