package simgsm.center.ui.ladder;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Locale;
import javax.swing.AbstractButton;
import javax.swing.BoundedRangeModel;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.JToggleButton;
import javax.swing.JViewport;
import javax.swing.KeyStroke;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.console.TextBundle;
import simgsm.ui.Arrange;
import simgsm.ui.CommandGroup;
import simgsm.ui.ComponentNames;
import simgsm.ui.DressedPanel;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.pane.DividedPanel;
import simgsm.ui.pane.Divider;

/** The GSM messages between terminals and centre, live; below, the selected message, unless it is shown elsewhere. */
public final class LadderPanel extends DressedPanel {
    private static final Dimension LIST_UNITS = new Dimension(560, 240);
    /** In a narrower panel the buttons have no words. */
    private static final int WIDE_UNITS = 900;

    /** In a narrower panel there is no heading. */
    private static final int HEADING_UNITS = 1040;

    private static final int LOW_UNITS = 330;
    private static final int MOST_COLUMNS = 3;
    private static final int SCROLL_BAR_UNITS = 10;
    /** The ladder's share of the height above the message, until the user moves the divider. */
    private static final double LADDER_SHARE = 0.5;

    /** Minimum height of ladder and message when the divider is moved. */
    private static final int LEAST_UNITS = 60;

    private final TextBundle texts;
    private final LadderModel model = new LadderModel();
    private final LadderCell cell = new LadderCell();
    private final LadderList list;
    private final LifelineHeader header;
    private final JScrollPane pane;
    /** Components in front of the tools. */
    private final JPanel front = Arrange.row(Theme.HALF);

    private final JPanel behind = Arrange.row(Theme.HALF);
    private final MessageDetail detail;
    private final JLabel heading = new JLabel();
    private final LadderFilterBar filter;
    private final JToggleButton pause;
    private final JToggleButton follow;
    private final JButton clear;
    private final JButton undo;
    private final JButton save;
    private final DividedPanel split;
    private final LadderSaving saving;
    private Runnable whenChosen = () -> {};
    private List<String> terminals = List.of();
    private boolean isHeadingWanted = true;
    private boolean isDetailElsewhere;

    public LadderPanel(TextBundle texts) {
        this.texts = texts;
        list = new LadderList(model, cell, texts.of("window.ladder.empty"));
        header = new LifelineHeader(list);
        detail = new MessageDetail(texts);
        filter = new LadderFilterBar(texts, this::filter);
        saving = new LadderSaving(texts);
        setOpaque(false);
        pause = toggle("ladder.pause", "window.ladder.pause", Symbol.PAUSE, this::paused);
        follow = toggle("ladder.follow", "window.ladder.follow", Symbol.FOLLOW, this::followed);
        follow.setSelected(true);
        clear = button("ladder.clear", "window.ladder.clear", Symbol.ERASE, this::clear);
        undo = button("ladder.undo", "window.ladder.undo", Symbol.UNDO, this::unclear);
        undo.setVisible(false);
        save = button("ladder.save", "window.ladder.save", Symbol.SAVE, this::save);
        new UserAction("ladder.undo.key", texts.of("window.ladder.undo"), this::unclear)
                .bind(list, WHEN_FOCUSED, KeyStroke.getKeyStroke(KeyEvent.VK_Z, InputEvent.CTRL_DOWN_MASK));
        new UserAction("ladder.explain", texts.of("window.ladder.explain"), detail::explain)
                .bind(list, WHEN_FOCUSED, KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0));
        pane = listPane();
        keepEndInView();
        Divider divider = new Divider(
                "divider.message",
                texts.of("divider.message"),
                Locale.forLanguageTag(texts.of("window.language")),
                LEAST_UNITS);
        split = new DividedPanel(false, pane, detail, divider, LEAST_UNITS, room -> (int) (room * (1 - LADDER_SHARE)));
        split.showSecond(false);
        add(tools(), BorderLayout.NORTH);
        add(split, BorderLayout.CENTER);
        list.addListSelectionListener(event -> chosen(list.getSelectedIndex()));
        dress();
    }

    private UserAction action(String id, String key, Symbol symbol, Runnable task) {
        return UserAction.of(texts, id, key, task).in(CommandGroup.VIEW).with(symbol.icon());
    }

    private JToggleButton toggle(String id, String key, Symbol symbol, Runnable task) {
        return ComponentNames.name(new JToggleButton(action(id, key, symbol, task)), id, texts.of(key));
    }

    private JButton button(String id, String key, Symbol symbol, Runnable task) {
        return ComponentNames.name(new JButton(action(id, key, symbol, task)), id, texts.of(key));
    }

    private JPanel tools() {
        heading.setText(texts.of("window.ladder"));
        JPanel row = Arrange.row(
                Theme.HALF, front, heading, Arrange.growing(filter), pause, follow, undo, clear, save, behind);
        front.setVisible(false);
        row.setBorder(Theme.padding(0, 0, Theme.HALF, 0));
        return row;
    }

    /** Adds components before the tools. */
    public void addInFront(JComponent... components) {
        List.of(components).forEach(front::add);
        front.setVisible(true);
    }

    /** Adds a component after the tools. */
    public void addBehind(JComponent component) {
        behind.add(component);
    }

    private JScrollPane listPane() {
        ComponentNames.name(list, "ladder.list", texts.of("window.ladder.name"));
        JScrollPane made = new JScrollPane(
                list,
                ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS,
                ScrollPaneConstants.HORIZONTAL_SCROLLBAR_AS_NEEDED);
        made.setColumnHeaderView(header);
        made.getViewport().setScrollMode(JViewport.SIMPLE_SCROLL_MODE); // times and protocols stay in view
        made.setPreferredSize(new Dimension(Theme.px(LIST_UNITS.width), Theme.px(LIST_UNITS.height)));
        made.setMinimumSize(new Dimension(0, 0));
        for (JScrollBar bar : List.of(made.getVerticalScrollBar(), made.getHorizontalScrollBar())) {
            bar.addAdjustmentListener(event -> {
                if (event.getValueIsAdjusting()) {
                    follow.setSelected(isAtEnd(bar.getModel()));
                }
            });
        }
        return made;
    }

    private static boolean isAtEnd(BoundedRangeModel bar) {
        return bar.getValue() + bar.getExtent() >= bar.getMaximum() - Theme.px(LadderDrawing.RUNG_UNITS);
    }

    /** Fits columns into a low panel's width; they scroll sideways. */
    private void arrangeColumns(boolean isLow) {
        int room = getWidth() - pane.getInsets().left - pane.getInsets().right;
        int most = Math.min(MOST_COLUMNS, room / Math.max(1, lifelines().leastColumnWidth()));
        int columns = isLow ? Math.max(1, most) : 1;
        if (columns != list.columns() || columns > 1 && room / columns != list.columnWidth()) {
            boolean inColumns = columns > 1;
            list.setColumns(columns, room / columns);
            pane.setVerticalScrollBarPolicy(
                    inColumns
                            ? ScrollPaneConstants.VERTICAL_SCROLLBAR_NEVER
                            : ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS);
            pane.setHorizontalScrollBarPolicy(
                    inColumns
                            ? ScrollPaneConstants.HORIZONTAL_SCROLLBAR_ALWAYS
                            : ScrollPaneConstants.HORIZONTAL_SCROLLBAR_AS_NEEDED);
            showChosenOrEnd();
        }
    }

    private void showChosenOrEnd() {
        SwingUtilities.invokeLater(() -> {
            int chosen = list.getSelectedIndex();
            list.ensureIndexIsVisible(chosen >= 0 && !follow.isSelected() ? chosen : model.getSize() - 1);
        });
    }

    /** Keeps the end visible after a change of size, which is only known after the layout. */
    private void keepEndInView() {
        ComponentAdapter resized = new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                followed();
            }
        };
        list.addComponentListener(resized);
        pane.getViewport().addComponentListener(resized);
    }

    /** The selected message, placed elsewhere after {@link #setDetailElsewhere}. */
    public MessageDetail detail() {
        return detail;
    }

    /** Sets an action after each selection of a message. */
    public void whenChosen(Runnable action) {
        whenChosen = action;
    }

    /** Moves the message elsewhere, because a low window has no space below the ladder. */
    public void setDetailElsewhere(boolean elsewhere) {
        isDetailElsewhere = elsewhere;
        placeDetail();
    }

    /** Focuses the messages. */
    @Override
    public boolean requestFocusInWindow() {
        return list.requestFocusInWindow();
    }

    public void show(ExchangeSnapshot snapshot) {
        int before = model.rows().size();
        model.update(snapshot.ladder(), snapshot.ladderCount());
        refreshLines();
        showPause();
        if (model.rows().size() != before) {
            header.revalidate();
            if (follow.isSelected()) {
                showEnd();
            }
        }
    }

    private String name(String key) {
        return texts.of(key).replace("&", "");
    }

    private void refreshLines() {
        List<String> now = model.terminals();
        if (!now.equals(terminals)) {
            terminals = now;
            filter.offer(now);
            showLines();
        }
    }

    private Lifelines lifelines() {
        return Lifelines.of(filter.filter().terminal().map(List::of).orElse(terminals));
    }

    private void showLines() {
        cell.show(lifelines());
        header.show(lifelines());
        list.fit();
        revalidate();
    }

    private void filter() {
        model.filter(filter.filter());
        showLines();
        followed();
    }

    /** Shows only this subscriber's messages. */
    public void choose(String number) {
        if (terminals.contains(number)) {
            filter.choose(number);
        }
    }

    private void clear() {
        model.clear();
        cleared();
    }

    private void unclear() {
        model.unclear();
        cleared();
        followed();
    }

    private void cleared() {
        undo.setVisible(model.isCleared());
        refreshLines();
        list.repaint();
        revalidate();
    }

    private void save() {
        saving.ask(save, model.rows(), lifelines());
    }

    private void paused() {
        model.pause(pause.isSelected());
        showPause();
        refreshLines();
        followed();
    }

    /** Shows the number of waiting messages on the button, in a narrow panel as a bare number. */
    private void showPause() {
        long held = model.heldBack();
        String words = hasWords() ? texts.of("window.ladder.held", held) : String.valueOf(held);
        String idle = hasWords() ? name("window.ladder.pause") : "";
        pause.setText(held == 0 ? idle : words);
    }

    private boolean hasWords() {
        return getWidth() >= Theme.px(WIDE_UNITS);
    }

    private void followed() {
        if (follow.isSelected()) {
            showEnd();
        }
    }

    /** Scrolls to the end after the layout of the new rows. */
    private void showEnd() {
        SwingUtilities.invokeLater(() -> list.ensureIndexIsVisible(model.getSize() - 1));
    }

    /** Stops following the latest message when an older one is selected. */
    private void chosen(int index) {
        if (index >= 0 && index < model.getSize() - 1 && list.isFocusOwner()) {
            follow.setSelected(false);
        }
        LadderRow row = list.getSelectedValue();
        if (row != null) {
            detail.show(row);
            whenChosen.run();
        } else if (index >= 0) {
            list.setSelectedIndex(model.firstIndex());
        }
        placeDetail();
    }

    /** Shows the message below the ladder once one is selected. */
    private void placeDetail() {
        boolean isHere = !isDetailElsewhere && list.getSelectedIndex() >= 0;
        if (isHere != split.hasSecond()) {
            split.showSecond(isHere);
            split.validate();
            list.ensureIndexIsVisible(list.getSelectedIndex());
        }
    }

    /** Shows the heading; without it the tools take the whole row. */
    public void setHeadingVisible(boolean visible) {
        isHeadingWanted = visible;
    }

    @Override
    public void doLayout() {
        for (AbstractButton button : new AbstractButton[] {follow, undo, clear, save}) {
            button.setHideActionText(!hasWords());
        }
        showPause();
        heading.setVisible(isHeadingWanted && getWidth() >= Theme.px(HEADING_UNITS));
        boolean isLow = getHeight() < Theme.px(LOW_UNITS);
        cell.setLow(isLow);
        header.setLow(isLow);
        arrangeColumns(isLow);
        if (list.getFixedCellHeight() != cell.getPreferredSize().height) {
            list.fit();
        }
        super.doLayout();
    }

    @Override
    protected void dress() {
        heading.setFont(Theme.title());
        pane.getHorizontalScrollBar().setPreferredSize(new Dimension(0, Theme.px(SCROLL_BAR_UNITS)));
        list.fit();
    }
}
