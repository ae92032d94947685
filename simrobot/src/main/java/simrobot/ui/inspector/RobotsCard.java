package simrobot.ui.inspector;

import java.awt.BorderLayout;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.CommandGroup;
import simgsm.ui.ComponentNames;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.drawing.PlaceNames;
import simrobot.process.BehaviourKind;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.OpenPort;
import simrobot.ui.OperatorActions;
import simrobot.ui.StatusLamps;
import simrobot.ui.TextLine;
import simrobot.ui.ToolButtons;
import vericommand.Pose;

/** The list of the robots, the selected one's status, process and ports, and the buttons that add and remove robots. */
final class RobotsCard extends JPanel {
    /** Prefix of the names of processes that drive to a place. */
    private static final String GOTO = "goto ";

    private final TextBundle texts;
    private final RobotList robots;
    private final StatusLamps statuses;
    private final TextLine ports = new TextLine("ports", Theme::monoSmall, Ink.QUIET);
    private final UserAction add;
    private final UserAction remove;
    private final JPanel buttons;
    private final JPanel process;
    private final JButton restoring;
    /** The robot removed last; empty once it exists again. */
    private Optional<Removed> removed = Optional.empty();

    private Optional<Removed> removable = Optional.empty();
    /** The name on the button that restores a robot. */
    private Optional<String> offered = Optional.empty();

    /** The data for restoring a removed robot. */
    private record Removed(String name, String number, Pose pose) {}

    private final JComboBox<String> behaviour = new JComboBox<>();
    private String selected = "";
    private BehaviourKind current = BehaviourKind.NONE;
    private List<BehaviourKind> choice = List.of();
    private boolean showing;

    /**
     * Creates the robots of a window.
     *
     * @param page the keys are bound to it
     * @param newRobot opens and closes the form for a new robot
     */
    RobotsCard(
            TextBundle texts,
            Consumer<String> selection,
            OperatorActions operator,
            JComponent page,
            Runnable newRobot) {
        super(new BorderLayout());
        this.texts = texts;
        setOpaque(false);
        robots = new RobotList(texts, selection);
        statuses = new StatusLamps(texts);
        add = new UserAction("robot.add", texts.of("robot.add"), newRobot)
                .in(CommandGroup.ROBOT)
                .with(Symbol.PLUS.icon(12));
        add.onKey(page, KeyEvent.VK_N, InputEvent.CTRL_DOWN_MASK).described(texts.of("robot.add.hint"));
        remove = new UserAction("robot.remove", texts.of("robot.remove"), () -> remove(operator))
                .in(CommandGroup.ROBOT)
                .with(Symbol.MINUS.icon(12));
        remove.described(texts.of("robot.remove.hint"));
        remove.bind(robots.list(), JComponent.WHEN_FOCUSED, KeyStroke.getKeyStroke(KeyEvent.VK_DELETE, 0));
        UserAction restore = new UserAction("robot.restore", texts.of("robot.restore.hint"), () -> restore(operator))
                .in(CommandGroup.ROBOT)
                .onKey(page, KeyEvent.VK_Z, InputEvent.CTRL_DOWN_MASK);
        restoring = ToolButtons.button(new JButton(), restore, texts.of("robot.restore"));
        restoring.setVisible(false);
        JPanel both = Arrange.row(
                Theme.HALF,
                ToolButtons.named(new JButton(), add),
                ToolButtons.named(new JButton(), remove),
                Arrange.spring());
        buttons = Arrange.column(Theme.HALF, both, restoring);
        offer(BehaviourKind.BUILT_IN);
        ComponentNames.name(behaviour, "robot.behaviour", texts.of("robot.behaviour"));
        behaviour.setToolTipText(texts.of("robot.behaviour.hint"));
        behaviour.addActionListener(event -> chosen(operator));
        JLabel label = new JLabel(texts.of("robot.behaviour"));
        label.setLabelFor(behaviour);
        process = Arrange.row(Theme.GRID, label, Arrange.growing(behaviour));
        step(page, KeyEvent.VK_DOWN, 1);
        step(page, KeyEvent.VK_UP, -1);
        add(new Card(
                texts.of("robots.title"), Arrange.column(10, robots.component(), buttons, statuses, process, ports)));
    }

    private void remove(OperatorActions operator) {
        removed = removable;
        operator.removeRobot(selected);
    }

    private void restore(OperatorActions operator) {
        removed.ifPresent(robot -> operator.addRobot(
                robot.name(), robot.number(), Optional.of(robot.pose()), refusal -> refusal.ifPresent(operator::tell)));
    }

    /** Offers the removed robot until it exists again; a real robot cannot be restored. */
    private void offerRestoring(List<RobotList.Row> rows, Optional<RobotSnapshot> shown) {
        removable = shown.filter(RobotSnapshot::simulated)
                .map(robot -> new Removed(
                        robot.name(),
                        rows.stream()
                                .filter(row -> row.name().equals(robot.name()))
                                .map(RobotList.Row::number)
                                .findFirst()
                                .orElse(""),
                        new Pose(robot.xMeters(), robot.yMeters(), Math.toDegrees(robot.headingRadians()))));
        Optional<String> gone = removed.map(Removed::name)
                .filter(name -> rows.stream().noneMatch(row -> row.name().equals(name)));
        if (!gone.equals(offered)) {
            boolean isBack = gone.isEmpty() && offered.equals(removed.map(Removed::name));
            removed = isBack ? Optional.empty() : removed;
            offered = gone;
            gone.ifPresent(name -> restoring.setText(texts.of("robot.restore", name)));
            restoring.setVisible(gone.isPresent());
            revalidate();
        }
    }

    /** Binds Ctrl and an arrow to the next or the previous robot in the whole window. */
    private void step(JComponent page, int key, int by) {
        new UserAction("robots.step." + by, "", () -> robots.step(by))
                .bindInWindow(page, KeyStroke.getKeyStroke(key, InputEvent.CTRL_DOWN_MASK));
    }

    /** Disables changes of a recording's robots. */
    void setLive(boolean live) {
        buttons.setVisible(live);
        add.setEnabled(live);
        process.setVisible(live);
    }

    static String word(TextBundle texts, BehaviourKind kind) {
        return switch (kind.text()) {
            case "none" -> texts.of("behaviour.none");
            case "wander" -> texts.of("behaviour.wander");
            case "wall-follow" -> texts.of("behaviour.wallFollow");
            default ->
                kind.text().startsWith(GOTO)
                        ? texts.of("behaviour.goTo", names(texts).of(kind.text().substring(GOTO.length())))
                        : kind.text();
        };
    }

    private static PlaceNames names(TextBundle texts) {
        return PlaceNames.in(Locale.forLanguageTag(texts.of("language.tag")));
    }

    /** Offers these kinds; a removed process remains while it runs. */
    private void offer(List<BehaviourKind> kinds) {
        if (!kinds.equals(choice) && !behaviour.isPopupVisible()) {
            choice = kinds;
            showing = true;
            behaviour.removeAllItems();
            kinds.forEach(kind -> behaviour.addItem(word(texts, kind)));
            behaviour.setSelectedIndex(kinds.indexOf(current));
            showing = false;
        }
    }

    /** Shows the robot's process, not the last choice, which is only a request. */
    private void chosen(OperatorActions operator) {
        int index = behaviour.getSelectedIndex();
        if (!showing && index >= 0 && !choice.get(index).equals(current)) {
            operator.setBehaviour(selected, choice.get(index));
        }
    }

    private void show(Optional<RobotSnapshot> robot, List<BehaviourKind> kinds) {
        current = robot.map(RobotSnapshot::behaviour).orElse(BehaviourKind.NONE);
        // a combo box is repainted even if this changes nothing
        if (behaviour.isEnabled() != robot.isPresent()) {
            behaviour.setEnabled(robot.isPresent());
        }
        List<BehaviourKind> all = new ArrayList<>(kinds);
        if (!all.contains(current)) {
            all.add(current);
        }
        offer(all);
        if (behaviour.getSelectedIndex() != choice.indexOf(current) && !behaviour.isPopupVisible()) {
            showing = true;
            behaviour.setSelectedIndex(choice.indexOf(current));
            showing = false;
        }
    }

    void show(List<RobotList.Row> rows, Optional<RobotSnapshot> shown, List<OpenPort> open, List<BehaviourKind> kinds) {
        selected = shown.map(RobotSnapshot::name).orElse("");
        robots.show(rows, selected);
        offerRestoring(rows, shown);
        show(shown, kinds);
        statuses.show(shown.map(RobotSnapshot::status).orElse(null));
        remove.setEnabled(shown.isPresent() && add.isEnabled());
        String text = portsText(open);
        ports.show(text);
        if (ports.isVisible() == text.isEmpty()) {
            ports.setVisible(!text.isEmpty());
        }
    }

    private String portsText(List<OpenPort> open) {
        List<String> own = open.stream()
                .filter(port -> port.robot().isEmpty() || port.robot().equals(selected))
                .map(port -> port.protocol() + " " + port.port())
                .toList();
        return own.isEmpty() ? "" : texts.of("robot.ports", String.join("  ", own));
    }
}
