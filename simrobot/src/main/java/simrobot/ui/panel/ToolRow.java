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
import java.util.function.UnaryOperator;
import javax.swing.AbstractButton;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import simgsm.console.TextBundle;
import simgsm.ui.Arrange;
import simgsm.ui.Drawing;
import simgsm.ui.Lamp;
import simgsm.ui.LinkState;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.drawing.Layers;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.OperatorActions;
import simrobot.ui.SplitRow;
import simrobot.ui.ToolButtons;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.floor.WorldView;

/**
 * The row above the floor: world, link, switches, time, and the tools of the floor. Its buttons have words where all of them
 * fit into one row, or in a high page into two; else icons, whose tool tips have the words.
 */
final class ToolRow extends JPanel {
    /** From this height of the page on, a second row for the words costs the floor little. */
    private static final int HIGH_PAGE_UNITS = 640;

    private final TextBundle texts;
    private final Locale language;
    private final OperatorActions operator;
    private final WorldView view;
    /** The keys are bound to it: it is visible also while this row is hidden. */
    private final JComponent page;

    private final WorldChoice worlds;
    private final Lamp link;
    private final JToggleButton power;
    private final JToggleButton motors;
    private final JButton pause;
    private final JButton step;
    private final JToggleButton follow;
    private final SpeedChoice speed;
    private final JToggleButton ruler;
    private final RecordButton record;
    private final ExportChoice exports;
    /** What changes robots or world; hidden while a recording is played. */
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
        power = worded(new JToggleButton(), "power", Symbol.POWER.icon(), KeyEvent.VK_P, this::switchPower);
        motors = worded(new JToggleButton(), "motors", Symbol.MOTOR.icon(), KeyEvent.VK_M, this::switchMotors);
        pause = button("pause", Symbol.PAUSE.icon(), KeyEvent.VK_SPACE, () -> operator.setPaused(!paused));
        step = button("step", Symbol.STEP.icon(), KeyEvent.VK_PERIOD, operator::stepOnce);
        follow = toggle("follow", Symbol.FOLLOW.icon(), KeyEvent.VK_G, () -> view.setFollowing(!view.isFollowing()));
        speed = new SpeedChoice(texts, operator);
        ruler = toggle("ruler", Symbol.RULER.icon(), KeyEvent.VK_R, view::toggleRuler);
        exports = new ExportChoice(texts, operator);
        JButton brake = worded(new JButton(), "brake", Symbol.BRAKE.icon(), KeyEvent.VK_B, () -> operator.brake(robot));
        record = new RecordButton(texts, operator);
        left = worldTools(brake);
        liveTools = List.of(worlds.component(), power, motors, brake, record.component());
        right = floorTools(inspectorSwitch);
        words.put(record.component(), texts.of("tool.record.word"));
        add(new SplitRow(left, right), BorderLayout.CENTER);
    }

    private JPanel worldTools(JButton brake) {
        List<JComponent> first = List.of(worlds.component(), gap(), link, gap(), power, motors, brake, gap());
        JPanel row = Arrange.row(Theme.HALF, first.toArray(JComponent[]::new));
        List.of(pause, step, speed.component(), record.component()).forEach(row::add);
        return row;
    }

    private JPanel floorTools(Runnable inspectorSwitch) {
        return Arrange.row(
                Theme.HALF,
                button("zoom.out", Symbol.MINUS.icon(), 0, () -> view.zoom(0.8)),
                button("zoom.in", Symbol.PLUS.icon(), 0, () -> view.zoom(1.25)),
                button("fit", Symbol.FIT.icon(), KeyEvent.VK_F, this::fit),
                follow,
                layer("trail", Symbol.TRAIL.icon(), KeyEvent.VK_T, shown -> shown.withTrail(!shown.trail())),
                layer("rays", Symbol.RAYS.icon(), KeyEvent.VK_S, shown -> shown.withSonar(!shown.sonar())),
                layer("grid", Symbol.GRID.icon(), KeyEvent.VK_G, shown -> shown.withGrid(!shown.grid())),
                ruler,
                exports.component(),
                button("inspector", Symbol.LIST.icon(), KeyEvent.VK_I, inspectorSwitch));
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
        follow.setSelected(view.isFollowing());
        ruler.setSelected(view.ruler() != null);
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

    /** @param key with Alt */
    private JToggleButton layer(String id, Icon icon, int key, UnaryOperator<Layers> change) {
        UserAction action = new UserAction(
                        "tool." + id, texts.of("tool." + id), () -> view.setLayers(change.apply(view.layers())))
                .with(icon)
                .onKey(page, key, InputEvent.ALT_DOWN_MASK);
        JToggleButton button = withWord(ToolButtons.icon(new JToggleButton(), action), id);
        button.setSelected(true);
        return button;
    }

    private JToggleButton toggle(String id, Icon icon, int key, Runnable task) {
        return withWord(ToolButtons.icon(new JToggleButton(), action(id, icon, key, task)), id);
    }

    private JButton button(String id, Icon icon, int key, Runnable task) {
        return withWord(ToolButtons.icon(new JButton(), action(id, icon, key, task)), id);
    }

    /** The icons of larger and smaller have none. */
    private <B extends AbstractButton> B withWord(B button, String id) {
        if (!id.startsWith("zoom.")) {
            words.put(button, texts.of("tool." + id + ".word"));
        }
        return button;
    }

    private <B extends AbstractButton> B worded(B button, String id, Icon icon, int key, Runnable task) {
        return ToolButtons.button(button, action(id, icon, key, task), texts.of("tool." + id + ".word"));
    }

    /** @param key with Ctrl, 0 for none */
    private UserAction action(String id, Icon icon, int key, Runnable task) {
        UserAction action = new UserAction("tool." + id, texts.of("tool." + id), task).with(icon);
        return key == 0 ? action.described(action.name()) : action.onKey(page, key, InputEvent.CTRL_DOWN_MASK);
    }
}
