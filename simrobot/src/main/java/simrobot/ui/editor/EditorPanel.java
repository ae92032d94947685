package simrobot.ui.editor;

import java.awt.BorderLayout;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.ButtonGroup;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.Timer;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.editor.Draft;
import simrobot.robot.Pioneer2Dx;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.EventThread;
import simrobot.ui.FileDialogs;
import simrobot.ui.OperatorActions;
import simrobot.ui.SplitRow;
import simrobot.ui.TextLine;
import simrobot.ui.ToolButtons;
import simrobot.world.Home;
import simrobot.world.World;

/** The world editor: rows of tools, the floor, and a sidebar with the items. */
public final class EditorPanel extends JPanel {
    private static final double[] RASTERS_METERS = {0, 0.1, 0.5};
    private static final String ENDING = "map";
    private static final int KEEP_AFTER_MILLIS = 200;

    private final TextBundle texts;
    private final OperatorActions operator;
    private final Runnable closed;
    private final EditorView floor;
    private final ItemSidebar sidebar;
    private final TextLine title = new TextLine("editor.file", Theme::title, Ink.TEXT);
    private final TextLine state = new TextLine("editor.state", Theme::base, Ink.QUIET).overTwoRows();
    private final Map<EditorTool, JToggleButton> tools = new HashMap<>();
    private final UserAction undo;
    private final UserAction redo;
    private final UserAction delete;
    private final UserAction apply;
    private final UserAction restore;
    private final JButton restoring;
    private final KeptDraft kept;
    private final Timer keeping = new Timer(KEEP_AFTER_MILLIS, event -> keepDraft());
    private Optional<World> left = Optional.empty();
    private Path file = Path.of("");
    private boolean named;
    private World applied;
    private String message = "";
    private boolean failed;

    /** @param closed run when the editor is left */
    public EditorPanel(TextBundle texts, OperatorActions operator, Runnable closed) {
        super(new BorderLayout());
        this.texts = texts;
        this.operator = operator;
        this.closed = closed;
        setOpaque(false);
        setName("editor");
        floor = new EditorView(texts, this::showState);
        sidebar = new ItemSidebar(texts, floor);
        undo = action("undo", Symbol.UNDO.icon(), KeyEvent.VK_Z, () -> floor.step(floor.draft()::undo));
        redo = action("redo", Symbol.REDO.icon(), KeyEvent.VK_Y, () -> floor.step(floor.draft()::redo));
        delete = action("delete", Symbol.ERASE.icon(), 0, () -> floor.step(floor.draft()::deleteSelected));
        delete.described(texts.of("editor.delete.hint"));
        apply = action("apply", Symbol.PLAY.icon(), KeyEvent.VK_ENTER, () -> apply(() -> {}));
        restore = action("restore", null, 0, this::restore);
        restoring = named(restore);
        kept = new KeptDraft(operator);
        keeping.setRepeats(false);
        JPanel files = Arrange.row(
                Theme.HALF,
                named(action("back", Symbol.LEFT.icon(), KeyEvent.VK_W, this::close)),
                Arrange.growing(title),
                restoring,
                named(action("save", null, KeyEvent.VK_S, () -> save(() -> {}))),
                named(saveAs()),
                named(apply));
        JPanel rows = Arrange.column(Theme.HALF, files, new SplitRow(toolRow(), editRow()));
        JPanel middle = Arrange.row(
                Theme.GRID, Arrange.growing(Arrange.column(Theme.GRID, Arrange.growing(floor), state)), sidebar);
        add(Arrange.column(Theme.GRID, rows, Arrange.growing(middle)));
    }

    private JPanel toolRow() {
        JPanel row = Arrange.row(Theme.HALF);
        ButtonGroup one = new ButtonGroup();
        for (EditorTool tool : EditorTool.ALL) {
            String name = texts.of("editor.tool." + tool.id());
            UserAction action = new UserAction("editor.tool." + tool.id(), name, () -> {
                        floor.setTool(tool);
                        floor.requestFocusInWindow();
                    })
                    .with(tool.symbol().icon())
                    .onKey(this, tool.key(), InputEvent.ALT_DOWN_MASK);
            JToggleButton button = ToolButtons.named(new JToggleButton(), action);
            one.add(button);
            tools.put(tool, button);
            row.add(button);
        }
        return row;
    }

    private JPanel editRow() {
        return Arrange.row(
                Theme.HALF,
                named(undo),
                named(redo),
                named(delete),
                rasters(),
                ToolButtons.icon(new JButton(), action("smaller", Symbol.MINUS.icon(), 0, () -> floor.zoom(0.8))),
                ToolButtons.icon(new JButton(), action("larger", Symbol.PLUS.icon(), 0, () -> floor.zoom(1.25))),
                ToolButtons.icon(new JButton(), action("fit", Symbol.FIT.icon(), KeyEvent.VK_F, floor::fit)));
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

    /** @param key with Ctrl, 0 for none */
    private UserAction action(String id, Icon icon, int key, Runnable task) {
        UserAction action = new UserAction("editor." + id, texts.of("editor." + id), task).with(icon);
        return key == 0 ? action.described(action.name()) : action.onKey(this, key, InputEvent.CTRL_DOWN_MASK);
    }

    private UserAction saveAs() {
        return action("saveAs", null, 0, () -> saveAs(() -> {}))
                .onKey(this, KeyEvent.VK_S, InputEvent.CTRL_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK);
    }

    private JButton named(UserAction action) {
        return ToolButtons.named(new JButton(), action);
    }

    // ---- the draft -------------------------------------------------------------------------------------------------

    /**
     * Begins to edit a world.
     *
     * @param place the file of the world, or the proposal for a new one
     * @param isThere true if the file exists and contains this world
     */
    public void edit(World world, Path place, boolean isThere, List<RobotSnapshot> robots) {
        file = place;
        named = isThere;
        applied = isThere ? world : null;
        left = KeptDraft.of(place).filter(draft -> !draft.equals(world.named(draft.name())));
        restoring.setVisible(left.isPresent());
        floor.edit(new Draft(world), robots);
        report(left.isPresent() ? texts.of("editor.left", place.getFileName()) : "", false);
        floor.setTool(EditorTool.ALL.get(isThere ? 0 : 1));
        floor.requestFocusInWindow();
    }

    public void showRobots(List<RobotSnapshot> robots) {
        floor.showRobots(robots);
    }

    /** Restores an earlier session's draft as one undo step. */
    private void restore() {
        left.ifPresent(draft -> floor.step(() -> floor.draft().change(draft)));
        left = Optional.empty();
        restoring.setVisible(false);
    }

    /** Writes a changed draft next to its file. */
    void keepDraft() {
        if (floor.draft().isChanged()) {
            kept.keep(floor.draft().committed(), file);
        }
    }

    private void dropKept() {
        keeping.stop();
        kept.drop(file);
    }

    private void report(String words, boolean failure) {
        message = words;
        failed = failure;
        showState();
    }

    private void showState() {
        Draft draft = floor.draft();
        undo.setEnabled(draft.canUndo());
        redo.setEnabled(draft.canRedo());
        delete.setEnabled(draft.selected().isPresent());
        apply.setEnabled(draft.committed() != applied);
        boolean changed = draft.isChanged() || !named;
        if (draft.isChanged()) {
            keeping.restart();
        }
        title.show(texts.of(changed ? "editor.file.changed" : "editor.file", file.getFileName()));
        tools.get(floor.tool()).setSelected(true);
        sidebar.show(draft);
        String hint = texts.of("editor.hint." + floor.tool().id());
        List<Home> blocked = floor.blockedHomes();
        if (failed || blocked.isEmpty()) {
            state.show(message.isEmpty() ? hint : message, failed ? Ink.DANGER : Ink.QUIET);
        } else {
            String names = blocked.stream().map(Home::name).collect(Collectors.joining(", "));
            state.show(texts.of("editor.homeBlocked", names, Pioneer2Dx.RADIUS_METERS), Ink.DANGER);
        }
    }

    // ---- apply, save, close ----------------------------------------------------------------------------------------

    /** @param done run when the robots are in the edited world */
    private void apply(Runnable done) {
        World draft = floor.draft().committed();
        World world = draft.named(file.getFileName().toString());
        operator.apply(world, file, EventThread.onEventThread(refusal -> {
            if (refusal.isEmpty()) {
                applied = draft;
                done.run();
            }
            report(refusal.orElse(texts.of("editor.applied")), refusal.isPresent());
        }));
    }

    private void save(Runnable done) {
        if (named && FileDialogs.withEnding(file, ENDING).equals(file)) {
            write(file, done);
        } else {
            saveAs(done);
        }
    }

    private void saveAs(Runnable done) {
        FileDialogs.save(texts, this, file.toAbsolutePath(), texts.of("editor.files"), ENDING)
                .ifPresent(chosen -> write(chosen, done));
    }

    /** @param done run when the file is written */
    void write(Path target, Runnable done) {
        World world = floor.draft().committed();
        operator.save(world, target, EventThread.onEventThread(refusal -> {
            if (refusal.isEmpty()) {
                dropKept();
                file = target;
                named = true;
                floor.draft().markSaved(world);
                done.run();
            }
            report(refusal.orElse(texts.of("editor.saved", target)), refusal.isPresent());
        }));
    }

    private void close() {
        leave(closed);
    }

    /**
     * Leaves the editor, after a question if there are unsaved changes.
     *
     * @param done run when it is left, unless the user stays
     */
    public void leave(Runnable done) {
        if (!floor.draft().isChanged()) {
            done.run();
            return;
        }
        switch (FileDialogs.askAboutChanges(texts, this, String.valueOf(file.getFileName()))) {
            case SAVE -> save(() -> applyAnd(done));
            case DROP -> {
                dropKept();
                done.run();
            }
            case STAY -> floor.requestFocusInWindow();
        }
    }

    /** Loads the saved world into the simulation, unless it is already loaded. */
    private void applyAnd(Runnable done) {
        if (floor.draft().committed() == applied) {
            done.run();
        } else {
            apply(done);
        }
    }
}
