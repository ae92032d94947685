package simrobot.ui.panel;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Card;
import simgsm.ui.CommandGroup;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.window.Display;
import simrobot.drawing.PlaceNames;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.OperatorActions;
import simrobot.ui.SimRobotTexts;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.TextLine;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.editor.EditorPanel;
import simrobot.ui.floor.WorldView;
import simrobot.ui.inspector.Inspector;
import simrobot.ui.inspector.RobotList;
import simrobot.ui.replay.TimelinePanel;
import simrobot.ui.telephone.ModemPanel;
import simrobot.ui.telephone.PresentationView;
import simrobot.ui.telephone.VeriCommandPanel;
import simrobot.world.World;

/** SimRobot's window without its frame: tools above; floor and inspector; modem and VeriCommand below the floor. */
public final class SimRobotPanel extends JPanel {
    private static final String RUNNING = "running";
    private static final String EDITING = "editing";
    private static final String NEW_WORLD = "new.map";

    private final TextBundle texts;
    private final OperatorActions operator;
    private final ToolRow tools;
    private final WorldView world;
    private final Inspector inspector;
    private final ModemPanel modem;
    private final VeriCommandPanel orders;
    private final TextLine notice = new TextLine("notice", Theme::strong, Ink.DANGER);
    private final JPanel noticeRow;
    private final CardLayout pages = new CardLayout();
    private final JPanel page = new JPanel(pages);
    /** Holds the running page and its keys, which are off in the editor. */
    private final JPanel running = new JPanel(new BorderLayout());

    private final EditorPanel editor;
    private boolean pausedBefore;
    private WindowSnapshot shown;
    private final BusyRobotNotice busyNotice;
    private final TimelinePanel timeline;
    private final PresentationView presentation;
    private final transient UserAction endPresentation;
    private final RunningPage runningPage;
    private String selected;
    private String requested;

    public SimRobotPanel(Locale language, WindowSnapshot first, OperatorActions operator) {
        super(new BorderLayout());
        this.operator = operator;
        texts = SimRobotTexts.in(language);
        shown = first;
        world = new WorldView(first.simulation(), texts, operator, this::select);
        world.setLayers(world.layers().withNames(PlaceNames.in(language)));
        tools = new ToolRow(texts, language, operator, world, this::edit, running, this::switchInspector);
        editor = new EditorPanel(texts, operator, this::stopEditing);
        inspector = new Inspector(texts, this::select, operator, world, running, this::showInspector);
        modem = new ModemPanel(texts, language, operator);
        orders = new VeriCommandPanel(texts, language);
        modem.whenHidingKeys(hiding -> {
            orders.setKeysHidden(hiding);
            line(selected).ifPresent(orders::show);
        });
        noticeRow = new Card(notice);
        noticeRow.setVisible(false);
        busyNotice = new BusyRobotNotice(texts, this::select);
        timeline = new TimelinePanel(texts, operator);
        presentation = new PresentationView(language);
        runningPage = new RunningPage(
                texts, tools, noticeRow, framed(world), busyNotice, modem, orders, timeline, inspector, presentation);
        page.setOpaque(false);
        page.setBorder(Theme.padding(Theme.GRID));
        running.setOpaque(false);
        running.add(runningPage);
        page.add(running, RUNNING);
        page.add(editor, EDITING);
        add(page, BorderLayout.CENTER);
        Theme.styled(this, panel -> panel.setBackground(Theme.color(Ink.SURFACE)));
        setName("simrobot");
        presentationKey("presentation", KeyEvent.VK_F11);
        endPresentation = presentationKey("presentation.end", KeyEvent.VK_ESCAPE);
        endPresentation.setEnabled(false);
        show(first);
    }

    private static JPanel framed(WorldView world) {
        JPanel frame = new JPanel(new BorderLayout());
        frame.add(world);
        frame.setBorder(Theme.padding(1));
        return Theme.styled(frame, panel -> panel.setBackground(Theme.color(Ink.LINE)));
    }

    private UserAction presentationKey(String id, int key) {
        UserAction action =
                new UserAction(id, texts.of("presentation"), this::switchPresentation).in(CommandGroup.VIEW);
        action.bindInWindow(running, KeyStroke.getKeyStroke(key, 0));
        return action;
    }

    /** Shows the newest snapshot. */
    public void show(WindowSnapshot newest) {
        shown = newest;
        if (robot(requested).isPresent()) {
            selected = requested;
            requested = null;
            operator.watch(selected);
        }
        busyNotice.show(newest.lines(), selected, !world.placing().isDragging());
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
        runningPage.setLinePresent(line.isPresent());
        newest.timeline().ifPresent(recorded -> {
            timeline.setVisible(true);
            timeline.show(recorded, newest.simulation().timeNanos());
        });
        line.ifPresent(modem::show);
        line.ifPresent(orders::show);
        line.ifPresent(presentation::show);
        showNotice(newest);
    }

    private void showNotice(WindowSnapshot newest) {
        String text = newest.notice().isEmpty() && newest.worldChanged()
                ? texts.of("world.changed", newest.worldFile().getFileName())
                : newest.notice();
        notice.show(text);
        if (noticeRow.isVisible() == text.isEmpty()) {
            noticeRow.setVisible(!text.isEmpty());
            revalidate();
        }
    }

    /** Selects a robot in the whole window, possibly once it is added. */
    void select(String robot) {
        if (robot(robot).isEmpty()) {
            requested = robot;
        } else if (!robot.equals(selected)) {
            selected = robot;
            operator.watch(robot);
            show(shown);
        }
    }

    private void showInspector() {
        if (!inspector.isVisible()) {
            runningPage.switchInspector();
        }
    }

    private void switchInspector() {
        runningPage.switchInspector();
    }

    /** Switches full screen with the floor and one large line. */
    private void switchPresentation() {
        runningPage.setPresenting(!runningPage.isPresenting());
        endPresentation.setEnabled(runningPage.isPresenting());
        Display.maximize(this, runningPage.isPresenting());
    }

    /** Pauses the simulation and shows the editor. @param isNew a new world, else the current one */
    private void edit(boolean isNew) {
        pausedBefore = shown.paused();
        operator.setPaused(true);
        World current = shown.simulation().world();
        Path file = shown.worldFile();
        editor.edit(
                isNew ? World.bare().named(NEW_WORLD) : current,
                isNew ? file.resolveSibling(NEW_WORLD) : file,
                !isNew,
                shown.simulation().robots());
        pages.show(page, EDITING);
    }

    /** Closes the window by the given action, unless the user keeps an editor with unsaved changes. */
    void leave(Runnable close) {
        if (editor.isVisible()) {
            editor.leave(close);
        } else {
            close.run();
        }
    }

    private void stopEditing() {
        pages.show(page, RUNNING);
        operator.setPaused(pausedBefore);
        focusFloor();
    }

    // ----------------------------------------------------------------------------------------------------------------

    /** For tests: a menu is not in the tree of components. */
    public WorldChoice worldChoice() {
        return tools.worldChoice();
    }

    /** Gives the floor the keyboard focus. */
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
}
