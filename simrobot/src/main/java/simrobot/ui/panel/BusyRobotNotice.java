package simrobot.ui.panel;

import java.awt.BorderLayout;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JPanel;
import simgsm.air.Msisdn;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.TextLine;
import simrobot.ui.ToolButtons;

/**
 * Announces calls and orders to unselected robots. A robot that becomes busy is selected while the selected one is
 * idle; otherwise a notice names it, with a button that selects it.
 */
final class BusyRobotNotice extends JPanel {
    private final TextBundle texts;
    private final Consumer<String> select;
    private final TextLine text = new TextLine("elsewhere", Theme::strong, Ink.ACCENT);
    private final UserAction show;
    private Set<String> busy = Set.of();
    private String other = "";

    BusyRobotNotice(TextBundle texts, Consumer<String> select) {
        super(new BorderLayout());
        this.texts = texts;
        this.select = select;
        setOpaque(false);
        show = new UserAction("elsewhere.show", texts.of("elsewhere.show"), () -> select.accept(other));
        add(new Card(Arrange.row(Theme.GRID, Arrange.growing(text), ToolButtons.named(new JButton(), show))));
        setVisible(false);
    }

    /** @param maySelect true if another robot may be selected now */
    void show(List<TelephoneSnapshot> lines, String selected, boolean maySelect) {
        Set<String> before = busy;
        List<TelephoneSnapshot> commanded =
                lines.stream().filter(TelephoneSnapshot::isBusy).toList();
        busy = commanded.stream().map(TelephoneSnapshot::robot).collect(Collectors.toCollection(HashSet::new));
        Optional<TelephoneSnapshot> elsewhere = commanded.stream()
                .filter(line -> !line.robot().equals(selected))
                .findFirst();
        Optional<TelephoneSnapshot> begun = commanded.stream()
                .filter(line -> !before.contains(line.robot()))
                .findFirst();
        if (begun.isPresent() && !busy.contains(selected) && maySelect) {
            select.accept(begun.get().robot());
        } else {
            showNotice(elsewhere);
        }
    }

    private void showNotice(Optional<TelephoneSnapshot> line) {
        other = line.map(TelephoneSnapshot::robot).orElse("");
        text.show(line.map(this::words).orElse(""));
        if (isVisible() != line.isPresent()) {
            setVisible(line.isPresent());
            revalidate();
        }
    }

    private String words(TelephoneSnapshot line) {
        if (!line.isInCall()) {
            return texts.of("elsewhere.order", line.robot());
        }
        String peer = line.modem().peer().map(Msisdn::digits).orElse(texts.of("order.from.unknown"));
        return texts.of("elsewhere.call", line.robot(), peer);
    }
}
