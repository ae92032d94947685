package simrobot.ui.panel;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import javax.swing.AbstractButton;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import simgsm.console.TextBundle;
import simgsm.ui.Arrange;
import simgsm.ui.CommandGroup;
import simgsm.ui.Drawing;
import simgsm.ui.Lamp;
import simgsm.ui.LinkState;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.window.MenuButton;
import simrobot.drawing.Layers;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.OperatorActions;
import simrobot.ui.SplitRow;
import simrobot.ui.ToolButtons;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.floor.WorldView;

/**
 * The row above the floor: menu, world, link, switches, time, and the tools of the floor; the other commands of the floor are
 * in the menu only. Its buttons have words where all of them
 * fit into one row, or in a high page into two; else icons, whose tool tips have the words.
 */
final class ToolRow extends JPanel {
    /** Height of the page at which a second row for the words is affordable. */
    private static final int HIGH_PAGE_UNITS = 640;

    private final TextBundle texts;
    private final Locale language;
    private final OperatorActions operator;
    private final WorldView view;
    /** The component of the key bindings: visible even while this row is hidden. */
    private final JComponent page;

    private final WorldChoice worlds;
    private final Lamp link;
    private final JToggleButton power;
    private final JToggleButton motors;
    private final JButton pause;
    private final JButton step;
    private final UserAction follow;
    private final SpeedChoice speed;
    private final UserAction ruler;
    private final Map<UserAction, Predicate<Layers>> layers = new LinkedHashMap<>();
    private final RecordButton record;
    private final ExportCommands exports;
    /** Tools that change robots or world; hidden in a recording. */
    private final List<JComponent> liveTools;

    private final Map<AbstractButton, String> words = new LinkedHashMap<>();
    private final JPanel left;
    private final JPanel right;
    private boolean hasWords;
    private String robot = "";
    private boolean paused;

    ToolRow(
            TextBundle texts,
            Locale language,
            OperatorActions operator,
            WorldView view,
            Consumer<Boolean> editing,
            JComponent page,
            Runnable inspectorSwitch) {
        super(new BorderLayout());
        this.texts = texts;
        this.language = language;
        this.operator = operator;
        this.view = view;
        this.page = page;
        setOpaque(false);
        worlds = new WorldChoice(texts, operator, editing);
        link = Lamp.ofLink(language);
        power = worded(new JToggleButton(), "power", Symbol.POWER, KeyEvent.VK_P, this::switchPower);
        motors = worded(new JToggleButton(), "motors", Symbol.MOTOR, KeyEvent.VK_M, this::switchMotors);
        pause = button("pause", CommandGroup.WORLD, Symbol.PAUSE, KeyEvent.VK_SPACE, () -> operator.setPaused(!paused));
        step = button("step", CommandGroup.WORLD, Symbol.STEP, KeyEvent.VK_PERIOD, operator::stepOnce);
        follow = action("follow", CommandGroup.VIEW, KeyEvent.VK_G, () -> view.setFollowing(!view.isFollowing()));
        speed = new SpeedChoice(texts, operator);
        ruler = action("ruler", CommandGroup.VIEW, KeyEvent.VK_R, view::toggleRuler);
        layer("trail", KeyEvent.VK_T, Layers::trail, shown -> shown.withTrail(!shown.trail()));
        layer("rays", KeyEvent.VK_S, Layers::sonar, shown -> shown.withSonar(!shown.sonar()));
        layer("grid", KeyEvent.VK_G, Layers::grid, shown -> shown.withGrid(!shown.grid()));
        showSwitches();
        exports = new ExportCommands(texts, operator, page);
        JButton brake = worded(new JButton(), "brake", Symbol.BRAKE, KeyEvent.VK_B, () -> operator.brake(robot));
        record = new RecordButton(texts, operator);
        left = worldTools(brake);
        liveTools = List.of(worlds.component(), power, motors, brake, record.component());
        right = floorTools(inspectorSwitch);
        words.put(record.component(), texts.of("tool.record.word"));
        add(new SplitRow(left, right), BorderLayout.CENTER);
    }

    private JPanel worldTools(JButton brake) {
        MenuButton menu = new MenuButton(language);
        List<JComponent> first = List.of(menu, worlds.component(), gap(), link, gap(), power, motors, brake, gap());
        JPanel row = Arrange.row(Theme.HALF, first.toArray(JComponent[]::new));
        List.of(pause, step, speed.component()).forEach(row::add);
        return row;
    }

    private JPanel floorTools(Runnable inspectorSwitch) {
        return Arrange.row(
                Theme.HALF,
                record.component(),
                button("zoom.out", CommandGroup.VIEW, Symbol.MINUS, 0, () -> view.zoom(0.8)),
                button("zoom.in", CommandGroup.VIEW, Symbol.PLUS, 0, () -> view.zoom(1.25)),
                button("fit", CommandGroup.VIEW, Symbol.FIT, KeyEvent.VK_F, this::fit),
                button("inspector", CommandGroup.VIEW, Symbol.LIST, KeyEvent.VK_I, inspectorSwitch));
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        fitWords(width);
        super.setBounds(x, y, width, height);
    }

    private void fitWords(int width) {
        int ofLeft = wordsWidth(left);
        int ofRight = wordsWidth(right);
        int leftIcons = left.getPreferredSize().width - (hasWords ? ofLeft : 0);
        int rightIcons = right.getPreferredSize().width - (hasWords ? ofRight : 0);
        int icons = leftIcons + Theme.px(Theme.GRID) + rightIcons;
        boolean hasTwoRows = icons > width || page.getHeight() >= Theme.px(HIGH_PAGE_UNITS);
        boolean fitsInTwo = Math.max(leftIcons + ofLeft, rightIcons + ofRight) <= width;
        hasWords = icons + ofLeft + ofRight <= width || hasTwoRows && fitsInTwo;
        words.forEach((button, word) -> button.setText(hasWords ? word : null));
    }

    private int wordsWidth(JPanel row) {
        return words.entrySet().stream()
                .filter(word ->
                        word.getKey().getParent() == row && word.getKey().isVisible())
                .mapToInt(word -> Drawing.width(word.getKey().getFont(), word.getValue())
                        + word.getKey().getIconTextGap()
                        + 1)
                .sum();
    }

    void show(WindowSnapshot newest, Optional<RobotSnapshot> selected, Optional<LinkState> linkState) {
        worlds.show(newest.worldFile());
        boolean live = newest.timeline().isEmpty();
        for (JComponent tool : liveTools) {
            tool.setVisible(live);
        }
        record.show(newest.recording());
        link.setVisible(linkState.isPresent());
        linkState.ifPresent(state -> link.show(state, language));
        robot = selected.map(RobotSnapshot::name).orElse("");
        boolean on = selected.map(RobotSnapshot::powered).orElse(false);
        power.setEnabled(selected.isPresent());
        power.setSelected(on);
        motors.setEnabled(on);
        motors.setSelected(selected.map(RobotSnapshot::motors).orElse(false));
        showSwitches();
        exports.show(robot, newest.worldFile());
        speed.show(newest.speed());
        showPaused(newest.paused());
    }

    private void showPaused(boolean nowPaused) {
        step.setEnabled(nowPaused);
        if (nowPaused != paused) {
            paused = nowPaused;
            String key = paused ? "tool.resume" : "tool.pause";
            pause.setIcon((paused ? Symbol.PLAY : Symbol.PAUSE).icon());
            pause.setToolTipText(texts.of(key));
            pause.getAccessibleContext().setAccessibleName(texts.of(key));
            words.put(pause, texts.of(key));
            fitWords(getWidth());
        }
    }

    WorldChoice worldChoice() {
        return worlds;
    }

    private void fit() {
        view.setFollowing(false);
        view.fit();
    }

    // Switches show the robot's state, not the last click; so a click requests the opposite of that state.

    private void switchPower() {
        view.selectedRobot().ifPresent(shown -> operator.setPower(robot, !shown.powered()));
    }

    private void switchMotors() {
        view.selectedRobot().ifPresent(shown -> operator.setMotors(robot, !shown.motors()));
    }

    // ---- buttons ---------------------------------------------------------------------------------------------------

    private static JComponent gap() {
        JPanel gap = new JPanel(null);
        gap.setOpaque(false);
        gap.setPreferredSize(new Dimension(Theme.GRID, 1));
        return gap;
    }

    /** A command of the menu. @param key with Alt */
    private void layer(String id, int key, Predicate<Layers> isOn, UnaryOperator<Layers> change) {
        UserAction action = new UserAction("tool." + id, texts.of("tool." + id), () -> {
                    view.setLayers(change.apply(view.layers()));
                    showSwitches();
                })
                .in(CommandGroup.VIEW)
                .onKey(page, key, InputEvent.ALT_DOWN_MASK);
        layers.put(action, isOn);
    }

    private void showSwitches() {
        follow.setOn(view.isFollowing());
        ruler.setOn(view.ruler() != null);
        layers.forEach((action, isOn) -> action.setOn(isOn.test(view.layers())));
    }

    private JButton button(String id, CommandGroup group, Symbol symbol, int key, Runnable task) {
        JButton button =
                ToolButtons.icon(new JButton(), action(id, group, key, task).with(symbol.icon()));
        if (!id.startsWith("zoom.")) {
            words.put(button, texts.of("tool." + id + ".word"));
        }
        return button;
    }

    private <B extends AbstractButton> B worded(B button, String id, Symbol symbol, int key, Runnable task) {
        UserAction action = action(id, CommandGroup.ROBOT, key, task).with(symbol.icon());
        return ToolButtons.button(button, action, texts.of("tool." + id + ".word"));
    }

    /** @param key with Ctrl, 0 for none */
    private UserAction action(String id, CommandGroup group, int key, Runnable task) {
        UserAction action = new UserAction("tool." + id, texts.of("tool." + id), task).in(group);
        return key == 0 ? action.described(action.name()) : action.onKey(page, key, InputEvent.CTRL_DOWN_MASK);
    }
}
