package simrobot.ui.panel;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JPanel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.OperatorActions;
import simrobot.ui.SimRobotTexts;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.TextLine;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.editor.EditorPanel;
import simrobot.ui.floor.WorldView;
import simrobot.ui.replay.TimelinePanel;
import simrobot.world.World;

/** SimRobot's whole window without its frame: tools, floor and inspector, and below them modem and VeriCommand. */
public final class SimRobotPanel extends JPanel {
    private static final String RUNNING = "running";
    private static final String EDITING = "editing";
    private static final String NEW_WORLD = "new.map";

    /** In units; in a lower window the floor needs the room more than the scope's faders do. */
    private static final int LEAST_ROOMY_HEIGHT = 640;

    private final TextBundle texts;
    private final OperatorActions operator;
    private final ToolRow tools;
    private final WorldView world;
    private final Inspector inspector;
    private final ModemPanel modem;
    private final VeriCommandPanel orders;
    private final TextLine notice = new TextLine("notice", Theme::strong, Ink.DANGER);
    private final JPanel noticeRow;
    private final CardLayout sheet = new CardLayout();
    private final JPanel sheets = new JPanel(sheet);
    private final EditorPanel editor;
    private boolean pausedBefore;
    private WindowSnapshot shown;
    private final BusyRobotNotice elsewhere;
    private final TimelinePanel timeline;
    private final JPanel bottom;
    private String selected;
    private String wished;

    /** A window that shows the given snapshot until it gets a newer one. */
    public SimRobotPanel(Locale language, WindowSnapshot first, OperatorActions operator) {
        super(new BorderLayout());
        this.operator = operator;
        texts = SimRobotTexts.in(language);
        shown = first;
        world = new WorldView(first.simulation(), texts, operator, this::select);
        tools = new ToolRow(texts, language, operator, world, this::edit);
        editor = new EditorPanel(texts, operator, this::stopEditing);
        inspector = new Inspector(texts, this::select, operator, world);
        modem = new ModemPanel(texts, language, operator);
        orders = new VeriCommandPanel(texts, language);
        noticeRow = new Card(notice);
        noticeRow.setVisible(false);
        elsewhere = new BusyRobotNotice(texts, this::select);
        JPanel floor = new Framed(world);
        bottom = Arrange.row(Theme.GRID, Arrange.growing(modem), orders);
        timeline = new TimelinePanel(texts, operator);
        JPanel left = Arrange.column(Theme.GRID, Arrange.growing(floor), elsewhere, bottom, timeline);
        JPanel middle = Arrange.row(Theme.GRID, Arrange.growing(left), inspector);
        JPanel all = Arrange.column(Theme.GRID, tools, noticeRow, Arrange.growing(middle));
        sheets.setOpaque(false);
        sheets.setBorder(Theme.padding(Theme.GRID));
        sheets.add(all, RUNNING);
        sheets.add(editor, EDITING);
        add(sheets, BorderLayout.CENTER);
        setBackground(Theme.color(Ink.SURFACE));
        setName("simrobot");
        show(first);
    }

    /** Shows the newest snapshot. */
    public void show(WindowSnapshot newest) {
        shown = newest;
        if (robot(wished).isPresent()) {
            selected = wished;
            wished = null;
            operator.watch(selected);
        }
        elsewhere.show(newest.lines(), selected, !world.placing().isDragging());
        if (robot(selected).isEmpty()) {
            selected = newest.simulation().robots().stream()
                    .findFirst()
                    .map(RobotSnapshot::name)
                    .orElse(null);
            operator.watch(selected);
        }
        Optional<RobotSnapshot> robot = robot(selected);
        Optional<TelephoneSnapshot> line = line(selected);
        if (editor.isVisible()) {
            editor.showRobots(newest.simulation().robots());
        }
        world.setLive(newest.timeline().isEmpty());
        world.select(selected);
        world.show(newest.simulation());
        tools.show(newest, robot, line.map(l -> ModemPanel.linkState(l.modem())));
        inspector.show(rows(), robot, newest);
        bottom.setVisible(line.isPresent());
        newest.timeline().ifPresent(recorded -> {
            timeline.setVisible(true);
            timeline.show(recorded, newest.simulation().timeNanos());
        });
        line.ifPresent(modem::show);
        line.ifPresent(orders::show);
        String told = newest.notice().isEmpty() && newest.worldChanged()
                ? texts.of("world.changed", newest.worldFile().getFileName())
                : newest.notice();
        notice.show(told);
        if (noticeRow.isVisible() == told.isEmpty()) {
            noticeRow.setVisible(!told.isEmpty());
            revalidate();
        }
    }

    /** Makes this robot the one that the whole window is about. */
    void select(String robot) {
        if (robot(robot).isEmpty()) {
            wished = robot;
        } else if (!robot.equals(selected)) {
            selected = robot;
            operator.watch(robot);
            show(shown);
        }
    }

    // ---- editing ---------------------------------------------------------------------------------------------------

    /** While a world is edited, time stands still. @param fresh a new world, else the present one */
    private void edit(boolean fresh) {
        pausedBefore = shown.paused();
        operator.setPaused(true);
        World present = shown.simulation().world();
        Path file = shown.worldFile();
        editor.edit(
                fresh ? World.bare().named(NEW_WORLD) : present,
                fresh ? file.resolveSibling(NEW_WORLD) : file,
                !fresh,
                shown.simulation().robots());
        sheet.show(sheets, EDITING);
    }

    private void stopEditing() {
        sheet.show(sheets, RUNNING);
        operator.setPaused(pausedBefore);
        focusFloor();
    }

    // ----------------------------------------------------------------------------------------------------------------

    /** For tests: its menu is not in the tree of components. */
    public WorldChoice worldChoice() {
        return tools.worldChoice();
    }

    /** The floor, which should have the keyboard first. */
    public void focusFloor() {
        world.requestFocusInWindow();
    }

    private Optional<RobotSnapshot> robot(String name) {
        return shown.simulation().robots().stream()
                .filter(robot -> robot.name().equals(name))
                .findFirst();
    }

    private Optional<TelephoneSnapshot> line(String robot) {
        return shown.lines().stream().filter(line -> line.robot().equals(robot)).findFirst();
    }

    private List<RobotList.Row> rows() {
        return shown.simulation().robots().stream()
                .map(robot -> new RobotList.Row(
                        robot.name(),
                        robot.status(),
                        line(robot.name()).map(TelephoneSnapshot::number).orElse(""),
                        line(robot.name()).filter(TelephoneSnapshot::isInCall).isPresent()))
                .toList();
    }

    @Override
    public void doLayout() {
        modem.setCompact(getHeight() < Theme.px(LEAST_ROOMY_HEIGHT));
        super.doLayout();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        setBackground(Theme.color(Ink.SURFACE));
    }

    /** A thin line about the floor. */
    private static final class Framed extends JPanel {
        Framed(WorldView view) {
            super(new BorderLayout());
            setOpaque(false);
            setBorder(Theme.padding(1));
            add(view, BorderLayout.CENTER);
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            Graphics2D g = Drawing.on(graphics);
            try {
                g.setColor(Theme.color(Ink.LINE));
                g.fillRect(0, 0, getWidth(), getHeight());
            } finally {
                g.dispose();
            }
        }
    }
}
