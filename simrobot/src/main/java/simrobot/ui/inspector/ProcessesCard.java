package simrobot.ui.inspector;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.KeyEvent;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.VerticalScrollPane;
import simrobot.control.LoggedEvent;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import simrobot.ui.OperatorActions;
import simrobot.ui.ToolButtons;
import simrobot.ui.WrappedText;

/** All processes by their numbers, to be started in the selected robot, and faults of students' processes. */
final class ProcessesCard extends JPanel {
    /** Number of lines shown of the latest output of the selected robot's processes. */
    private static final int SHOWN_LINES = 8;

    private final TextBundle texts;
    private final DefaultListModel<String> rows = new DefaultListModel<>();
    private final JList<String> list = new JList<>(rows);
    private final WrappedText faults;
    private final WrappedText printed;
    private final UserAction stop;
    private List<BehaviourKind> kinds = List.of();
    private Map<BehaviourKind, Integer> numbers = Map.of();
    private String robot = "";

    ProcessesCard(TextBundle texts, OperatorActions operator) {
        super(new BorderLayout());
        this.texts = texts;
        setOpaque(false);
        ComponentNames.name(list, "processes", texts.of("processes.title"));
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        UserAction start = new UserAction("processes.start", texts.of("processes.start"), () -> start(operator))
                .described(texts.of("processes.start.hint"));
        start.bind(list, JComponent.WHEN_FOCUSED, KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0));
        stop = new UserAction(
                        "processes.stop",
                        texts.of("processes.stop"),
                        () -> operator.setBehaviour(robot, BehaviourKind.NONE))
                .described(texts.of("processes.stop.hint"));
        faults = new WrappedText("processes.faults", texts.of("processes.faults"), Ink.DANGER);
        printed = new WrappedText("processes.printed", texts.of("processes.printed"), Ink.TEXT);
        JPanel buttons = Arrange.row(
                Theme.HALF,
                ToolButtons.named(new JButton(), start),
                ToolButtons.named(new JButton(), stop),
                Arrange.spring());
        add(new Card(
                texts.of("processes.title"),
                Arrange.column(Theme.GRID, buttons, Arrange.growing(new VerticalScrollPane(list)), printed, faults)));
    }

    private void start(OperatorActions operator) {
        int index = list.getSelectedIndex();
        if (index >= 0 && index < kinds.size()) {
            operator.setBehaviour(robot, kinds.get(index));
        }
    }

    void show(SimulationSnapshot scene, Optional<RobotSnapshot> selected, List<LoggedEvent> events) {
        robot = selected.map(RobotSnapshot::name).orElse("");
        BehaviourKind running = selected.map(RobotSnapshot::behaviour).orElse(BehaviourKind.NONE);
        stop.setEnabled(!running.equals(BehaviourKind.NONE));
        kinds = scene.behaviours()
                .subList(
                        Math.min(1, scene.behaviours().size()),
                        scene.behaviours().size());
        numbers = new HashMap<>();
        scene.numberedBehaviours().forEach((number, kind) -> numbers.put(kind, number));
        showRows(running);
        String text = scene.behaviourFaults().stream().map(this::fault).collect(Collectors.joining("\n"));
        faults.show(text);
        List<String> lines = events.stream()
                .filter(event ->
                        event.robot().equals(robot) && event.line().name().equals("printed"))
                .map(event -> event.line().fields().get("text"))
                .toList();
        printed.show(String.join("\n", lines.subList(Math.max(0, lines.size() - SHOWN_LINES), lines.size())));
    }

    /** Replaces changed rows one by one, so that the selection is kept. */
    private void showRows(BehaviourKind running) {
        for (int i = 0; i < kinds.size(); i++) {
            String row = row(kinds.get(i), kinds.get(i).equals(running));
            if (i >= rows.size()) {
                rows.addElement(row);
            } else if (!rows.get(i).equals(row)) {
                rows.set(i, row);
            }
        }
        if (rows.size() > kinds.size()) {
            rows.removeRange(kinds.size(), rows.size() - 1);
        }
    }

    private String row(BehaviourKind kind, boolean running) {
        String number = numbers.containsKey(kind) ? "#*" + numbers.get(kind) : "    ";
        String row = number + "  " + RobotsCard.word(texts, kind);
        return running ? texts.of("processes.running", row) : row;
    }

    private String fault(BehaviourList.Fault fault) {
        return fault.line() == 0
                ? fault.name() + ": " + fault.text()
                : texts.of("processes.fault", fault.name(), String.valueOf(fault.line()), fault.text());
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(180), Theme.px(160));
    }
}
