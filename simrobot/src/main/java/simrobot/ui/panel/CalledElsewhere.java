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
import simgsm.ui.Act;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.Named;
import simgsm.ui.Texts;
import simgsm.ui.Theme;
import simgsm.ui.Theme.Ink;
import simrobot.ui.CompactButtons;
import simrobot.ui.LineSnapshot;
import simrobot.ui.TextLine;

/**
 * Looks after calls and orders to robots that are not selected. While nobody commands the selected one the window goes over
 * to the one that is commanded; otherwise it says who is, and offers to.
 */
final class CalledElsewhere extends JPanel {
    private final Texts texts;
    private final Consumer<String> select;
    private final TextLine text = new TextLine("elsewhere", Theme::strong, Ink.ACCENT);
    private final Act show;
    private Set<String> busy = Set.of();
    private String other = "";

    CalledElsewhere(Texts texts, Consumer<String> select) {
        super(new BorderLayout());
        this.texts = texts;
        this.select = select;
        setOpaque(false);
        show = new Act("elsewhere.show", texts.of("elsewhere.show"), () -> select.accept(other));
        JButton button = Named.name(new JButton(show), "elsewhere.show", texts.of("elsewhere.show"));
        JPanel row = Arrange.row(Theme.GRID, Arrange.growing(text), button);
        CompactButtons.buttonsIn(row);
        add(new Card(row));
        setVisible(false);
    }

    /** @param mayLeave whether the window may go over to another robot now */
    void show(List<LineSnapshot> lines, String selected, boolean mayLeave) {
        Set<String> before = busy;
        List<LineSnapshot> commanded =
                lines.stream().filter(LineSnapshot::isBusy).toList();
        busy = commanded.stream().map(LineSnapshot::robot).collect(Collectors.toCollection(HashSet::new));
        Optional<LineSnapshot> elsewhere = commanded.stream()
                .filter(line -> !line.robot().equals(selected))
                .findFirst();
        Optional<LineSnapshot> begun = commanded.stream()
                .filter(line -> !before.contains(line.robot()))
                .findFirst();
        if (begun.isPresent() && !busy.contains(selected) && mayLeave) {
            select.accept(begun.get().robot());
        } else {
            tell(elsewhere);
        }
    }

    private void tell(Optional<LineSnapshot> line) {
        other = line.map(LineSnapshot::robot).orElse("");
        text.show(line.map(this::words).orElse(""));
        if (isVisible() != line.isPresent()) {
            setVisible(line.isPresent());
            revalidate();
        }
    }

    private String words(LineSnapshot line) {
        if (!line.isInCall()) {
            return texts.of("elsewhere.order", line.robot());
        }
        String peer = line.modem().peer().map(Msisdn::digits).orElse(texts.of("order.from.unknown"));
        return texts.of("elsewhere.call", line.robot(), peer);
    }
}
