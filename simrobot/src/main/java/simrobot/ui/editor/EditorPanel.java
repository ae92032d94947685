package simrobot.ui.editor;

import java.awt.BorderLayout;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.ButtonGroup;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.editor.Draft;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.CompactButtons;
import simrobot.ui.EventThread;
import simrobot.ui.FileDialogs;
import simrobot.ui.OperatorActions;
import simrobot.ui.SplitRow;
import simrobot.ui.TextLine;
import simrobot.world.World;

/** The world editor: a tool row, the floor that is edited, and a sheet with the items. */
public final class EditorPanel extends JPanel {
    private static final double[] RASTERS_METERS = {0, 0.1, 0.5};
    private static final int CTRL = InputEvent.CTRL_DOWN_MASK;

    private final TextBundle texts;
    private final OperatorActions operator;
    private final Runnable closed;
    private final EditorView floor;
    private final ItemSidebar sheet;
    private final TextLine title = new TextLine("editor.file", Theme::title, Ink.TEXT);
    private final TextLine state = new TextLine("editor.state", Theme::base, Ink.QUIET);
    private final Map<EditorTool, JToggleButton> tools = new EnumMap<>(EditorTool.class);
    private final JPanel rows;
    private UserAction undo;
    private UserAction redo;
    private UserAction delete;
    private UserAction apply;
    private Path file = Path.of("");
    private boolean named;
    private World applied;
    private String said = "";
    private boolean failed;

    /** @param closed run when the person is done */
    public EditorPanel(TextBundle texts, OperatorActions operator, Runnable closed) {
        super(new BorderLayout());
        this.texts = texts;
        this.operator = operator;
        this.closed = closed;
        setOpaque(false);
        setName("editor");
        floor = new EditorView(texts, this::tell);
        sheet = new ItemSidebar(texts, floor);
        JPanel files = Arrange.row(
                Theme.HALF,
                button("back", Symbol.LEFT.icon(), KeyEvent.VK_W, this::close, true),
                Arrange.growing(title),
                button("save", null, KeyEvent.VK_S, () -> save(() -> {}), true),
                button("saveAs", null, 0, () -> saveAs(() -> {}), true),
                button("apply", Symbol.PLAY.icon(), KeyEvent.VK_ENTER, this::apply, true));
        rows = Arrange.column(Theme.HALF, files, new SplitRow(toolRow(), editRow()));
        CompactButtons.buttonsIn(rows);
        JPanel middle = Arrange.row(
                Theme.GRID, Arrange.growing(Arrange.column(Theme.GRID, Arrange.growing(floor), state)), sheet);
        add(Arrange.column(Theme.GRID, rows, Arrange.growing(middle)));
    }

    private JPanel toolRow() {
        JPanel row = Arrange.row(Theme.HALF);
        ButtonGroup one = new ButtonGroup();
        for (EditorTool tool : EditorTool.values()) {
            String name = texts.of("editor.tool." + tool.id());
            JToggleButton button = new JToggleButton();
            UserAction act = new UserAction("editor.tool." + tool.id(), name, () -> {
                floor.setTool(tool);
                floor.requestFocusInWindow();
            });
            act.bindInWindow(this, KeyStroke.getKeyStroke(tool.key(), InputEvent.ALT_DOWN_MASK));
            button.setAction(
                    act.with(tool.symbol().icon()).described(name + "  (Alt+" + KeyEvent.getKeyText(tool.key()) + ")"));
            button.setIconTextGap(Theme.HALF);
            one.add(button);
            tools.put(tool, ComponentNames.name(button, act.id(), name));
            row.add(button);
        }
        return row;
    }

    private JPanel editRow() {
        JPanel row = Arrange.row(
                Theme.HALF,
                button("undo", Symbol.UNDO.icon(), KeyEvent.VK_Z, () -> step(floor.draft()::undo), false),
                button("redo", Symbol.REDO.icon(), KeyEvent.VK_Y, () -> step(floor.draft()::redo), false),
                button("delete", Symbol.ERASE.icon(), KeyEvent.VK_D, () -> step(floor.draft()::deleteSelected), false),
                rasters(),
                button("smaller", Symbol.MINUS.icon(), 0, () -> floor.zoom(0.8), false),
                button("larger", Symbol.PLUS.icon(), 0, () -> floor.zoom(1.25), false),
                button("fit", Symbol.FIT.icon(), KeyEvent.VK_F, floor::fit, false));
        return row;
    }

    private JComboBox<String> rasters() {
        JComboBox<String> box = new JComboBox<>();
        for (double meters : RASTERS_METERS) {
            box.addItem(meters == 0 ? texts.of("editor.raster.none") : texts.of("editor.raster.of", meters));
        }
        box.setSelectedIndex(1);
        box.addActionListener(event -> floor.setRaster(RASTERS_METERS[box.getSelectedIndex()]));
        box.setToolTipText(texts.of("editor.raster"));
        return ComponentNames.name(box, "editor.raster", texts.of("editor.raster"));
    }

    private AbstractButton button(String id, Icon icon, int key, Runnable deed, boolean worded) {
        String name = texts.of("editor." + id);
        UserAction act = new UserAction("editor." + id, name, deed);
        if (icon != null) {
            act.with(icon);
        }
        if (key != 0) {
            act.bindInWindow(this, KeyStroke.getKeyStroke(key, CTRL));
        }
        JButton button =
                new JButton(act.described(name + (key == 0 ? "" : "  (Ctrl+" + KeyEvent.getKeyText(key) + ")")));
        button.setHideActionText(!worded);
        button.setIconTextGap(Theme.HALF);
        keep(id, act);
        return ComponentNames.name(button, act.id(), name);
    }

    private void keep(String id, UserAction act) {
        switch (id) {
            case "undo" -> undo = act;
            case "redo" -> redo = act;
            case "delete" -> delete = act;
            case "apply" -> apply = act;
            default -> {
                // can always be done
            }
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (rows != null) {
            CompactButtons.buttonsIn(rows);
        }
    }

    // ---- the draft -------------------------------------------------------------------------------------------------

    /**
     * Begins to edit.
     *
     * @param place where the world is saved, or might be
     * @param isThere whether it is, as this world
     */
    public void edit(World world, Path place, boolean isThere, List<RobotSnapshot> robots) {
        file = place;
        named = isThere;
        applied = isThere ? world : null;
        say("", false);
        floor.edit(new Draft(world), robots);
        floor.setTool(isThere ? EditorTool.SELECT : EditorTool.WALL);
        floor.requestFocusInWindow();
    }

    public void showRobots(List<RobotSnapshot> robots) {
        floor.showRobots(robots);
    }

    private void step(Runnable deed) {
        deed.run();
        floor.fireChanged();
    }

    private void say(String words, boolean failure) {
        said = words;
        failed = failure;
        tell();
    }

    private void tell() {
        Draft draft = floor.draft();
        if (undo == null || sheet == null) {
            return;
        }
        undo.setEnabled(draft.canUndo());
        redo.setEnabled(draft.canRedo());
        delete.setEnabled(draft.selected().isPresent());
        apply.setEnabled(draft.committed() != applied);
        boolean changed = draft.isChanged() || !named;
        title.show(texts.of(changed ? "editor.file.changed" : "editor.file", file.getFileName()));
        tools.get(floor.tool()).setSelected(true);
        sheet.show(draft);
        String hint = texts.of("editor.hint." + floor.tool().id());
        state.show(said.isEmpty() ? hint : said, failed ? Ink.DANGER : Ink.QUIET);
    }

    // ---- apply, save, close ----------------------------------------------------------------------------------------

    private void apply() {
        World world = floor.draft().committed().named(file.getFileName().toString());
        World draft = floor.draft().committed();
        operator.apply(world, file, EventThread.onEventThread(refusal -> {
            if (refusal.isEmpty()) {
                applied = draft;
            }
            say(refusal.orElse(texts.of("editor.applied")), refusal.isPresent());
        }));
    }

    private void save(Runnable done) {
        if (named && FileDialogs.withEnding(file).equals(file)) {
            write(file, done);
        } else {
            saveAs(done);
        }
    }

    private void saveAs(Runnable done) {
        FileDialogs.choose(texts, this, file).ifPresent(chosen -> write(chosen, done));
    }

    /** @param done run when it is on the disk */
    void write(Path target, Runnable done) {
        World world = floor.draft().committed();
        operator.save(world, target, EventThread.onEventThread(refusal -> {
            if (refusal.isEmpty()) {
                file = target;
                named = true;
                floor.draft().markSaved(world);
                done.run();
            }
            say(refusal.orElse(texts.of("editor.saved", target)), refusal.isPresent());
        }));
    }

    private void close() {
        boolean unsaved = floor.draft().isChanged();
        FileDialogs.Leaving leaving =
                unsaved ? FileDialogs.ask(texts, this, String.valueOf(file.getFileName())) : FileDialogs.Leaving.DROP;
        switch (leaving) {
            case SAVE -> save(this::leave);
            case DROP -> leave(Optional.empty());
            case STAY -> floor.requestFocusInWindow();
        }
    }

    /** What was saved is what the robots are to have, too. */
    private void leave() {
        leave(Optional.of(floor.draft().committed()));
    }

    private void leave(Optional<World> world) {
        if (world.isPresent() && world.get() != applied) {
            operator.apply(
                    world.get().named(file.getFileName().toString()), file, EventThread.onEventThread(refusal -> {
                        if (refusal.isEmpty()) {
                            closed.run();
                        } else {
                            say(refusal.get(), true);
                        }
                    }));
        } else {
            closed.run();
        }
    }
}
