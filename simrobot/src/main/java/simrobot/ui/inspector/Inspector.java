package simrobot.ui.inspector;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.Dimension;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JToggleButton;
import simgsm.console.TextBundle;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.CommandGroup;
import simgsm.ui.ComponentNames;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.VerticalScrollPane;
import simgsm.ui.pane.ScrolledColumn;
import simrobot.drawing.NumberTexts;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.OperatorActions;
import simrobot.ui.ToolButtons;
import simrobot.ui.ValueRow;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.floor.WorldView;

/** The column at the right of the floor: the robots, and the state of the selected one, the processes or the events. */
public final class Inspector extends JPanel {
    private static final String ROBOT = "robot";
    private static final String EVENTS = "events";
    private static final String PROCESSES = "processes";
    /** Minimum height for both the list of the robots and a sheet. */
    private static final int LOW_UNITS = 520;

    private final RobotsCard robots;
    private final NewRobotForm newRobot;
    private final EventsCard events;
    private final ProcessesCard processes;
    private final CardLayout sheets = new CardLayout();
    private final JPanel sheet = new JPanel(sheets);
    private final ValueRow x;
    private final ValueRow y;
    private final ValueRow heading;
    private final ValueRow speed;
    private final ValueRow turn;
    private final ValueRow battery;
    private final OdometryCard wheels;
    private final SonarRose sonar;
    private final CameraView camera;
    private final String low;
    private final Runnable wanted;
    private final JToggleButton robotTab;
    private final JPanel top;
    private final JPanel robotSheet;
    /** True if robots and form share the first sheet, so that each sheet has the whole height. */
    private boolean isLow;

    private List<String> names = List.of();
    private List<String> numbers = List.of();

    /**
     * Creates the inspector of a window.
     *
     * @param page visible even while the inspector is hidden; the keys are bound to it
     * @param wanted run when a tab is selected
     */
    public Inspector(
            TextBundle texts,
            Consumer<String> selection,
            OperatorActions operator,
            WorldView view,
            JComponent page,
            Runnable wanted) {
        super(new BorderLayout());
        this.wanted = wanted;
        setOpaque(false);
        low = texts.of("pose.battery.low");
        newRobot = new NewRobotForm(texts, operator, view);
        robots = new RobotsCard(texts, selection, operator, page, this::toggleNewRobotForm);
        events = new EventsCard(texts);
        processes = new ProcessesCard(texts, operator);
        x = new ValueRow("pose.x", "x", "m");
        y = new ValueRow("pose.y", "y", "m");
        heading = new ValueRow("pose.heading", texts.of("pose.heading"), "\u00b0");
        speed = new ValueRow("pose.speed", texts.of("pose.speed"), "m/s");
        turn = new ValueRow("pose.turn", texts.of("pose.turn"), "\u00b0/s");
        battery = new ValueRow("pose.battery", texts.of("pose.battery"), "V");
        wheels = new OdometryCard(texts);
        sonar = new SonarRose(texts);
        camera = new CameraView(texts);
        Card pose = new Card(texts.of("pose.title"), Arrange.column(0, x, y, heading, speed, turn, battery))
                .folding("fold.pose");
        Card rose = new Card(texts.of("sonar.title"), sonar).folding("fold.sonar");
        Card picture = new Card(texts.of("camera.title"), camera).folding("fold.camera");
        sheet.setOpaque(false);
        robotSheet = Arrange.column(Theme.GRID, pose, picture, Arrange.growing(rose), wheels);
        JScrollPane state = scrolled(robotSheet);
        sheet.add(ComponentNames.name(state, "inspector", texts.of("tab.robot")), ROBOT);
        sheet.add(events, EVENTS);
        sheet.add(processes, PROCESSES);
        robotTab = tab("tab.robot", texts, page, KeyEvent.VK_1, ROBOT);
        top = Arrange.column(Theme.GRID, robots, newRobot, tabs(texts, page));
        add(Arrange.column(Theme.GRID, top, Arrange.growing(sheet)), BorderLayout.CENTER);
    }

    private static JScrollPane scrolled(JPanel content) {
        JScrollPane all = new ColumnScrollPane(new ScrolledColumn(content)).bare();
        all.setFocusable(true);
        PaintedComponent.repaintOnFocus(all);
        return all;
    }

    /** Creates the tabs of the lower part: the robot, the events, the processes. */
    private JPanel tabs(TextBundle texts, JComponent page) {
        JToggleButton log = tab("tab.events", texts, page, KeyEvent.VK_2, EVENTS);
        JToggleButton own = tab("tab.processes", texts, page, KeyEvent.VK_3, PROCESSES);
        ButtonGroup one = new ButtonGroup();
        one.add(robotTab);
        one.add(log);
        one.add(own);
        robotTab.setSelected(true);
        return Arrange.row(Theme.HALF, Arrange.growing(robotTab), Arrange.growing(log), Arrange.growing(own));
    }

    private JToggleButton tab(String id, TextBundle texts, JComponent page, int key, String name) {
        JToggleButton button = new JToggleButton();
        UserAction action = new UserAction(id, texts.of(id), () -> {
            wanted.run();
            button.setSelected(true);
            sheets.show(sheet, name);
        });
        return ToolButtons.tab(button, action.in(CommandGroup.VIEW).onKey(page, key, InputEvent.ALT_DOWN_MASK));
    }

    @Override
    public void doLayout() {
        boolean low = isTooLow(newRobot.isVisible());
        if (low != isLow) {
            isLow = low;
            JPanel place = low ? robotSheet : top;
            place.add(robots, 0);
            place.add(newRobot, 1);
        }
        super.doLayout();
    }

    private boolean isTooLow(boolean withForm) {
        return getHeight() < Theme.px(LOW_UNITS) + (withForm ? newRobot.getPreferredSize().height : 0);
    }

    private void toggleNewRobotForm() {
        wanted.run();
        if (isTooLow(true) && !robotTab.isSelected()) {
            robotTab.doClick(0);
        }
        newRobot.toggle(names, numbers);
        revalidate();
    }

    /** Reserves width for its view and its scroll bar, so that the view keeps its width when the bar appears. */
    private static final class ColumnScrollPane extends VerticalScrollPane {
        ColumnScrollPane(ScrolledColumn column) {
            super(column);
        }

        @Override
        public Dimension getPreferredSize() {
            Dimension view = super.getPreferredSize();
            Dimension bar = getVerticalScrollBar().getPreferredSize();
            return getVerticalScrollBar().isVisible() ? new Dimension(view.width + bar.width, view.height) : view;
        }
    }

    public void show(List<RobotList.Row> rows, Optional<RobotSnapshot> selected, WindowSnapshot newest) {
        names = rows.stream().map(RobotList.Row::name).toList();
        numbers = rows.stream().map(RobotList.Row::number).toList();
        robots.show(rows, selected, newest.ports(), newest.simulation().behaviours());
        robots.setLive(newest.timeline().isEmpty());
        wheels.setVisible(newest.timeline().isEmpty());
        selected.ifPresent(wheels::show);
        processes.show(newest.simulation(), selected, newest.events());
        events.show(newest.events(), selected.map(RobotSnapshot::name).orElse(""));
        selected.ifPresent(this::show);
        selected.ifPresent(robot -> camera.show(newest.simulation(), robot));
    }

    private void show(RobotSnapshot robot) {
        x.show(NumberTexts.meters(robot.xMeters()));
        y.show(NumberTexts.meters(robot.yMeters()));
        heading.show(NumberTexts.degrees(robot.headingRadians()));
        speed.show(NumberTexts.fixed(robot.speedMetersPerSecond(), 2));
        turn.show(NumberTexts.fixed(Math.toDegrees(robot.turnRadiansPerSecond()), 1));
        String volts = NumberTexts.fixed(robot.condition().batteryVolts(), 1);
        battery.show(robot.condition().batteryLow() ? low + " " + volts : volts);
        sonar.show(robot.sonarRangesMeters());
    }
}
