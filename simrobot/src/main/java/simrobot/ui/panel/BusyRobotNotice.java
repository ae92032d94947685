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
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.ui.CompactButtons;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.TextLine;

/**
 * Looks after calls and orders to robots that are not selected. While nobody commands the selected one the window goes over
 * to the one that is commanded; otherwise it says who is, and offers to.
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
        JButton button = ComponentNames.name(new JButton(show), "elsewhere.show", texts.of("elsewhere.show"));
        JPanel row = Arrange.row(Theme.GRID, Arrange.growing(text), button);
        CompactButtons.buttonsIn(row);
        add(new Card(row));
        setVisible(false);
    }

    /** @param mayLeave whether the window may go over to another robot now */
    void show(List<TelephoneSnapshot> lines, String selected, boolean mayLeave) {
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
        if (begun.isPresent() && !busy.contains(selected) && mayLeave) {
            select.accept(begun.get().robot());
        } else {
            tell(elsewhere);
        }
    }

    private void tell(Optional<TelephoneSnapshot> line) {
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
