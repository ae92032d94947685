package simrobot.ui.panel;

import java.awt.BorderLayout;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import javax.swing.AbstractButton;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Lamp;
import simgsm.ui.LinkState;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.window.WindowKeys;
import simrobot.drawing.Layers;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.CompactButtons;
import simrobot.ui.OperatorActions;
import simrobot.ui.SplitRow;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.floor.WorldView;

/** The row above the floor: world, link, switches, time, and what the floor shows. */
final class ToolRow extends JPanel {
    private final TextBundle texts;
    private final Locale language;
    private final OperatorActions operator;
    private final WorldView view;
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
    /** What changes robots or world; not there while a recording is looked at. */
    private final List<JComponent> acts;

    private final ExportChoice exports;
    private String robot = "";
    private boolean paused;

    ToolRow(TextBundle texts, Locale language, OperatorActions operator, WorldView view, Consumer<Boolean> editing) {
        super(new BorderLayout());
        this.texts = texts;
        this.language = language;
        this.operator = operator;
        this.view = view;
        setOpaque(false);
        worlds = new WorldChoice(texts, operator, editing);
        link = Lamp.ofLink(language);
        power = toggle("power", Symbol.POWER.icon(), KeyEvent.VK_P, () -> operator.setPower(robot, switchOf("power")));
        motors = toggle(
                "motors", Symbol.MOTOR.icon(), KeyEvent.VK_M, () -> operator.setMotors(robot, switchOf("motors")));
        pause = button("pause", Symbol.PAUSE.icon(), KeyEvent.VK_SPACE, () -> operator.setPaused(!paused));
        step = button("step", Symbol.STEP.icon(), KeyEvent.VK_PERIOD, operator::stepOnce);
        follow = toggle("follow", Symbol.FOLLOW.icon(), KeyEvent.VK_G, () -> view.setFollowing(!view.isFollowing()));
        speed = new SpeedChoice(texts, operator);
        ruler = toggle("ruler", Symbol.RULER.icon(), KeyEvent.VK_R, view::toggleRuler);
        exports = new ExportChoice(texts, operator);
        JButton brake = button("brake", Symbol.BRAKE.icon(), KeyEvent.VK_B, () -> operator.brake(robot));
        worded(brake, "brake");
        worded(power, "power");
        worded(motors, "motors");
        record = new RecordButton(texts, operator);
        JPanel running = Arrange.row(
                Theme.HALF, worlds.component(), gap(), link, gap(), power, motors, brake, gap(), pause, step);
        running.add(speed.component());
        running.add(record.component());
        acts = List.of(worlds.component(), power, motors, brake, record.component());
        add(new SplitRow(running, looking()), BorderLayout.CENTER);
        CompactButtons.buttonsIn(this);
    }

    /** What the floor shows. */
    private JPanel looking() {
        return Arrange.row(
                Theme.HALF,
                button("zoom.out", Symbol.MINUS.icon(), 0, () -> view.zoom(0.8)),
                button("zoom.in", Symbol.PLUS.icon(), 0, () -> view.zoom(1.25)),
                button("fit", Symbol.FIT.icon(), KeyEvent.VK_F, this::fit),
                follow,
                layer("trail", Symbol.TRAIL.icon(), KeyEvent.VK_T, shown -> shown.withTrail(!shown.trail())),
                layer("rays", Symbol.RAYS.icon(), KeyEvent.VK_S, shown -> shown.withSonar(!shown.sonar())),
                layer("grid", Symbol.GRID.icon(), KeyEvent.VK_D, shown -> shown.withGrid(!shown.grid())),
                ruler,
                exports.component(),
                button("appearance", Symbol.SUN_MOON.icon(), 0, () -> WindowKeys.switchAppearance(this)));
    }

    @Override
    public void updateUI() {
        super.updateUI();
        CompactButtons.buttonsIn(this);
    }

    void show(WindowSnapshot newest, Optional<RobotSnapshot> selected, Optional<LinkState> linkState) {
        worlds.show(newest.worldFile());
        boolean live = newest.timeline().isEmpty();
        for (JComponent act : acts) {
            act.setVisible(live);
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
        }
    }

    WorldChoice worldChoice() {
        return worlds;
    }

    private void fit() {
        view.setFollowing(false);
        view.fit();
    }

    /** A switch shows what is, not what was clicked; so a click asks for the opposite of what the robot last told. */
    private boolean switchOf(String which) {
        return view.selectedRobot()
                .map(shown -> which.equals("power") ? !shown.powered() : !shown.motors())
                .orElse(true);
    }

    // ---- buttons ---------------------------------------------------------------------------------------------------

    private static JComponent gap() {
        JPanel gap = new JPanel(null);
        gap.setOpaque(false);
        gap.setPreferredSize(new java.awt.Dimension(Theme.GRID, 1));
        return gap;
    }

    private void worded(AbstractButton button, String key) {
        button.setText(texts.of("tool." + key + ".word"));
        button.setIconTextGap(Theme.HALF);
    }

    private JToggleButton layer(String id, Icon icon, int key, UnaryOperator<Layers> change) {
        JToggleButton button = toggle(id, icon, key, () -> view.setLayers(change.apply(view.layers())));
        button.setSelected(true);
        return button;
    }

    private JToggleButton toggle(String id, Icon icon, int key, Runnable deed) {
        return dressed(new JToggleButton(act(id, icon, key, deed)), id);
    }

    private JButton button(String id, Icon icon, int key, Runnable deed) {
        return dressed(new JButton(act(id, icon, key, deed)), id);
    }

    private <B extends AbstractButton> B dressed(B button, String id) {
        button.setText(null);
        button.setHideActionText(true);
        return ComponentNames.name(button, "tool." + id, texts.of("tool." + id));
    }

    /** With Ctrl and its letter an act is reached from everywhere in the window. */
    private UserAction act(String id, Icon icon, int key, Runnable deed) {
        String name = texts.of("tool." + id);
        UserAction act = new UserAction("tool." + id, name, deed).with(icon);
        if (key == 0) {
            return act.described(name);
        }
        KeyStroke stroke = KeyStroke.getKeyStroke(key, InputEvent.CTRL_DOWN_MASK);
        act.bindInWindow(this, stroke);
        return act.described(name + "  (Ctrl+" + KeyEvent.getKeyText(key) + ")");
    }
}
