package simgsm.center.ui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.msc.ExchangeSnapshot.SubscriberRow;
import simgsm.center.msc.call.CallView;
import simgsm.center.ui.ladder.LadderPanel;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.CommandGroup;
import simgsm.ui.ComponentNames;
import simgsm.ui.DressedPanel;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.pane.DividedPanel;
import simgsm.ui.pane.Divider;
import simgsm.ui.window.Display;

/** The content of M3's window: shows snapshots and passes the user's actions to the operator. Needs no display. */
public final class MonitorPanel extends DressedPanel {
    private static final Dimension SIZE_UNITS = new Dimension(1160, 700);
    private static final int LISTS_UNITS = 484;
    private static final int LADDER_UNITS = 570;
    private static final int LEAST_LISTS_UNITS = 366;
    private static final int LEAST_LADDER_UNITS = 440;
    /** A lower panel has the buttons in the header, the lists folded at first, and no heading of the ladder. */
    private static final int LOW_UNITS = 420;

    private static final int MARGIN_UNITS = 12;
    private static final int LOW_MARGIN_UNITS = 6;
    private static final int LOW_FIELDS_MARGIN_UNITS = 3;
    private static final int GAP_UNITS = 8;
    /** The lists' share of a change of width. */
    private static final double LEFT_SHARE = 0.3;

    private final TextBundle texts;
    private final Background background;
    private final HeaderPanel header;
    private final PassingPanel passing;
    private final RowsPanel<SubscriberRow> subscribers;
    private final RowsPanel<CallView> calls;
    private final MessagesPanel messages;
    private final BroadcastPanel broadcasts;
    private final LadderPanel ladder;
    private final JTabbedPane tabs = new JTabbedPane();
    private final DividedPanel split;
    private double shownZoom;
    private final JLabel notice = new JLabel(" ");
    private final JPanel column = new JPanel(new BorderLayout());
    private final JPanel lists = new JPanel(new BorderLayout());
    private final Card listsCard = new Card(lists);
    private final Card ladderCard;
    private final Card passingCard;
    private final JButton newPhone;
    private final JButton newRobot;
    private final JToggleButton listsSwitch;
    private final JToggleButton aloneSwitch;
    private boolean areFieldsShown = true;
    private boolean isLow;

    /**
     * @param texts of the centre's bundle;
     * @param operator performs the requests of buttons, on the background's worker
     */
    MonitorPanel(TextBundle texts, CenterActions operator, Background background) {
        this.texts = texts;
        this.background = background;
        passing = new PassingPanel(texts, operator.port());
        passingCard = new Card(passing);
        header = new HeaderPanel(texts, operator, shown -> {
            areFieldsShown = shown;
            passingCard.setVisible(shown);
        });
        ladder = new LadderPanel(texts);
        subscribers = Tables.subscribers(texts)
                .onChoice(row -> ladder.choose(row.number().digits()));
        calls = Tables.calls(texts);
        messages = new MessagesPanel(texts);
        broadcasts = new BroadcastPanel(texts, operator, background);
        newPhone = starter("new.phone", "window.new.phone", Symbol.PHONE, operator::newPhone);
        newRobot = starter("new.robot", "window.new.robot", Symbol.ROBOT, operator::newRobot);
        addTabs();
        arrangeLists();
        ladder.whenChosen(this::showMessage);
        ladderCard = new Card(ladder);
        Divider divider = new Divider(
                "divider.ladder",
                texts.of("divider.ladder"),
                Locale.forLanguageTag(texts.of("window.language")),
                LEAST_LADDER_UNITS);
        split = new DividedPanel(true, listsCard, ladderCard, divider, LEAST_LISTS_UNITS, MonitorPanel::ladderWidth);
        listsSwitch = toggle("lists.shown", "window.lists", Symbol.LIST, this::showLists);
        listsSwitch.setSelected(true);
        aloneSwitch = toggle("ladder.alone", "window.ladder.alone", Symbol.FIT, this::showAlone);
        ladder.addInFront(listsSwitch);
        ladder.addBehind(aloneSwitch);
        bindKeys();
        add(column, BorderLayout.CENTER);
        arrangeRows();
        dress();
    }

    private void bindKeys() {
        new UserAction("ladder.alone.key", texts.of("window.ladder.alone"), aloneSwitch::doClick)
                .bindInWindow(this, KeyStroke.getKeyStroke(KeyEvent.VK_F11, 0));
        new UserAction("ladder.back", texts.of("window.ladder.alone"), this::back)
                .bind(ladder, WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0));
    }

    private JToggleButton toggle(String id, String key, Symbol symbol, Runnable task) {
        UserAction action =
                UserAction.of(texts, id, key, task).in(CommandGroup.VIEW).with(symbol.icon());
        JToggleButton button = ComponentNames.name(new JToggleButton(action), id, texts.of(key));
        button.setHideActionText(true);
        return button;
    }

    private void arrangeRows() {
        column.removeAll();
        column.add(Arrange.column(isLow ? Theme.HALF : GAP_UNITS, header, passingCard, Arrange.growing(split)));
        column.revalidate();
    }

    private void showLists() {
        boolean shown = listsSwitch.isSelected();
        listsSwitch.setHideActionText(shown);
        if (shown != listsCard.isVisible()) {
            listsCard.setVisible(shown);
            split.revalidate();
        }
    }

    private void fold(boolean folded) {
        listsSwitch.setSelected(!folded);
        showLists();
    }

    /** Shows the ladder in full screen without header, fields and lists, or restores them. */
    private void showAlone() {
        boolean isAlone = aloneSwitch.isSelected();
        header.setVisible(!isAlone);
        passingCard.setVisible(!isAlone && areFieldsShown);
        fold(isAlone || isLow);
        Display.maximize(this, isAlone);
        ladder.requestFocusInWindow();
    }

    /** Closes the selected message, then the large ladder. */
    private void back() {
        if (isLow && listsSwitch.isSelected()) {
            fold(true);
            ladder.requestFocusInWindow();
        } else if (aloneSwitch.isSelected()) {
            aloneSwitch.doClick();
        }
    }

    private void addTabs() {
        ComponentNames.name(tabs, "tabs", texts.of("window.tabs"));
        tabs.addTab(texts.of("window.subscribers"), subscribers);
        tabs.addTab(texts.of("window.calls"), calls);
        tabs.addTab(texts.of("window.messages"), messages);
        tabs.addTab(texts.of("window.broadcast"), broadcasts);
        ComponentNames.name(notice, "notice", texts.of("window.notice"));
        lists.setOpaque(false);
        column.setOpaque(false);
    }

    /** @param key of the text; the key of its tool tip has the suffix {@code .why} */
    private JButton starter(String id, String key, Symbol symbol, Background.Action action) {
        UserAction starting = UserAction.of(texts, id, key, () -> start(action))
                .in(CommandGroup.NETWORK)
                .with(symbol.icon());
        return ComponentNames.name(new JButton(starting), id, texts.of(key + ".why"));
    }

    private void arrangeLists() {
        lists.removeAll();
        header.release();
        newPhone.setHideActionText(false);
        newRobot.setHideActionText(false);
        if (isLow) {
            header.take(newPhone, newRobot);
            // the notice stays marked
            lists.add(Arrange.column(Theme.HALF, Arrange.growing(tabs), Arrange.row(0, Arrange.growing(notice))));
        } else {
            lists.add(Arrange.column(
                    Theme.GRID,
                    Arrange.growing(tabs),
                    Arrange.row(Theme.GRID, newPhone, newRobot, Arrange.growing(notice))));
        }
        notice.setVisible(!isLow || !notice.getText().isBlank());
        lists.revalidate();
    }

    /** Shows the message; in a low panel as a tab among the lists, so that the ladder keeps its space. */
    private void showMessage() {
        if (isLow) {
            if (tabs.indexOfComponent(ladder.detail()) < 0) {
                tabs.addTab("", Symbol.LIST.icon(), ladder.detail(), texts.of("window.ladder.tab"));
                tabs.getAccessibleContext()
                        .getAccessibleChild(tabs.getTabCount() - 1)
                        .getAccessibleContext()
                        .setAccessibleName(texts.of("window.ladder.tab"));
            }
            tabs.setSelectedComponent(ladder.detail());
            fold(false);
        }
    }

    @Override
    public void doLayout() {
        boolean low = getHeight() < Theme.px(LOW_UNITS);
        if (low != isLow) {
            isLow = low;
            Component focused =
                    KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
            boolean isFocused = focused != null && isAncestorOf(focused);
            arrangeLists();
            arrangeRows();
            fold(low || aloneSwitch.isSelected());
            ladder.setHeadingVisible(!low);
            ladder.setDetailElsewhere(low);
            space();
            if (!low) {
                tabs.remove(ladder.detail());
            }
            // The parts were removed and added, which has lost the focus, and Escape with it.
            if (isFocused && !focused.requestFocusInWindow()) {
                requestFocusInWindow();
            }
        }
        super.doLayout();
    }

    /** Updates the rates; called about every second. */
    public void tick(long nowNanos) {
        header.tick(nowNanos);
    }

    /** Focuses the lists; while they are folded, the ladder. */
    @Override
    public boolean requestFocusInWindow() {
        return listsCard.isVisible() ? tabs.requestFocusInWindow() : ladder.requestFocusInWindow();
    }

    /** Shows the newest snapshot; called on the event thread. */
    public void show(ExchangeSnapshot snapshot) {
        header.show(snapshot);
        passing.show(snapshot);
        subscribers.show(byNumber(snapshot.subscribers()));
        calls.show(Stream.concat(snapshot.calls().stream(), snapshot.endedCalls().stream())
                .toList());
        messages.show(snapshot.messages());
        broadcasts.show(snapshot.broadcasts());
        ladder.show(snapshot);
    }

    private static List<SubscriberRow> byNumber(List<SubscriberRow> rows) {
        Comparator<String> shortFirst = Comparator.comparingInt(String::length);
        return rows.stream()
                .sorted(Comparator.comparing(
                        row -> row.number().digits(), shortFirst.thenComparing(Comparator.naturalOrder())))
                .toList();
    }

    private void start(Background.Action action) {
        background.run(action, failure -> {
            notice.setText(failure.map(cause -> texts.of("window.new.failed", cause.getMessage()))
                    .orElse(" "));
            notice.setToolTipText(failure.map(Exception::getMessage).orElse(null));
            notice.setVisible(!isLow || failure.isPresent());
        });
    }

    @Override
    protected void dress() {
        notice.setForeground(Theme.color(Ink.DANGER));
        setBackground(Theme.color(Ink.SURFACE));
        space();
        if (shownZoom != Theme.zoom()) {
            shownZoom = Theme.zoom();
            setPreferredSize(new Dimension(Theme.px(SIZE_UNITS.width), Theme.px(SIZE_UNITS.height)));
        }
    }

    /** Removes the margins of a low panel. */
    private void space() {
        int units = isLow ? LOW_MARGIN_UNITS : MARGIN_UNITS;
        setBorder(Theme.padding(units));
        List.of(listsCard, ladderCard).forEach(card -> card.setPadding(units));
        passingCard.setPadding(isLow ? LOW_FIELDS_MARGIN_UNITS : MARGIN_UNITS);
    }

    /** The ladder's share of a width; lists and ladder share a surplus or shortage. */
    private static int ladderWidth(int room) {
        int spare = room - Theme.px(LISTS_UNITS) - Theme.px(LADDER_UNITS);
        int own = Theme.px(LADDER_UNITS) + (int) (spare * (1 - LEFT_SHARE));
        return Math.max(Theme.px(LEAST_LADDER_UNITS), Math.min(room - Theme.px(LEAST_LISTS_UNITS), own));
    }
}
