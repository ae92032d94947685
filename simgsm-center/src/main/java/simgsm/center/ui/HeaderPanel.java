package simgsm.center.ui;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.ui.Arrange;
import simgsm.ui.CommandGroup;
import simgsm.ui.ComponentNames;
import simgsm.ui.Drawing;
import simgsm.ui.DressedPanel;
import simgsm.ui.Lamp;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.window.MenuButton;

/** Name, port, counts, rates, and the buttons for folding and quitting. */
final class HeaderPanel extends DressedPanel {
    private static final int ROW_GAP = 12;

    private final TextBundle texts;
    private final JLabel title = new JLabel("SMSyCT");
    private final JLabel network = new JLabel();
    private final NetworkAccess access;
    private final Lamp port;
    private final Lamp attached;
    private final Lamp calls;
    private final Lamp waiting;
    private final RatesLabel rateLabel = new RatesLabel();
    private final JPanel row;
    private final JPanel buttons;
    private List<JButton> starters = List.of();
    private boolean areWordsShown = true;
    private final Rates rates = new Rates();

    /** @param folding receives true to show the fields below the header */
    HeaderPanel(TextBundle texts, CenterActions operator, Consumer<Boolean> folding) {
        this.texts = texts;
        setOpaque(false);
        port = lamp("lamp.port", "window.port.name");
        attached = lamp("lamp.attached", "window.attached.name");
        calls = lamp("lamp.calls", "window.calls");
        waiting = lamp("lamp.waiting", "window.waiting.name");
        access = operator.access();
        String accessKey = "window.network." + access.name().toLowerCase(Locale.ROOT);
        network.setText(texts.of(accessKey));
        network.setToolTipText(texts.of(accessKey + ".why"));
        network.setName("network");
        buttons = buttons(operator, folding);
        MenuButton menu = new MenuButton(Locale.forLanguageTag(texts.of("window.language")));
        row = Arrange.row(
                ROW_GAP, menu, title, port, network, Arrange.growing(rateLabel), attached, calls, waiting, buttons);
        add(row, BorderLayout.CENTER);
        port.setToolTipText(network.getText() + ": " + network.getToolTipText());
        port.show(StatusMark.DISC, Ink.GOOD, texts.of("window.port", String.valueOf(operator.port())));
        ComponentNames.name(rateLabel, "rates", texts.of("window.rates.name"));
        rateLabel.setToolTipText(texts.of("window.rates.why"));
        showCounts(0, 0, 0);
        showRates();
        dress();
    }

    private JPanel buttons(CenterActions operator, Consumer<Boolean> folding) {
        JToggleButton fold = new JToggleButton();
        fold.setAction(new UserAction("window.fold", "", () -> {
                    fold.setIcon((fold.isSelected() ? Symbol.UP : Symbol.DOWN).icon());
                    folding.accept(fold.isSelected());
                })
                .described(texts.of("window.fold.why"))
                .with(Symbol.UP.icon()));
        fold.setSelected(true);
        UserAction quit = UserAction.of(texts, "window.quit", "window.quit", operator::quit)
                .in(CommandGroup.NETWORK);
        JPanel all = Arrange.row(
                8,
                ComponentNames.name(fold, "window.fold", texts.of("window.fold.why")),
                ComponentNames.name(new JButton(quit), "window.quit", texts.of("window.quit.why")));
        operator.link().ifPresent(show -> {
            UserAction link =
                    UserAction.of(texts, "window.link", "window.link", show).in(CommandGroup.NETWORK);
            all.add(ComponentNames.name(new JButton(link), "window.link", texts.of("window.link.why")), 0);
        });
        return all;
    }

    /** Adds buttons before the header's own until another container takes them. */
    void take(JButton... more) {
        for (int i = 0; i < more.length; i++) {
            buttons.add(more[i], i);
        }
        starters = List.of(more);
        areWordsShown = starters.stream().noneMatch(JButton::getHideActionText);
        revalidate();
    }

    /** Releases the buttons of {@link #take}. */
    void release() {
        starters = List.of();
    }

    /**
     * Hides the words of the buttons if space is short, then the registration policy, which the port's tool tip
     * repeats, and the program's name. The notice that other machines may register is hidden after the words.
     */
    @Override
    public void doLayout() {
        int words = areWordsShown ? 0 : wordsWidth();
        int all = row.getMinimumSize().width + words + hidden(network) + hidden(title);
        int wordsOff = all - wordsWidth();
        int nameOff = all - width(network);
        boolean isOpen = access == NetworkAccess.OPEN_TO_OTHERS;
        int first = isOpen ? wordsOff : nameOff;
        int second = isOpen ? nameOff : wordsOff;
        if (all <= getWidth()) {
            show(true, true);
        } else if (first <= getWidth()) {
            show(!isOpen, isOpen);
        } else {
            show(isOpen && second <= getWidth(), !isOpen && second <= getWidth());
        }
        setVisible(title, wordsOff - width(network) <= getWidth());
        super.doLayout();
    }

    private static int width(JLabel label) {
        return label.getPreferredSize().width + Theme.px(ROW_GAP);
    }

    private static int hidden(JLabel label) {
        return label.isVisible() ? 0 : width(label);
    }

    private int wordsWidth() {
        return starters.stream()
                .mapToInt(button -> Drawing.width(button.getFont(), ((UserAction) button.getAction()).name())
                        + button.getIconTextGap())
                .sum();
    }

    /** Leaves unchanged components alone, because each change requests another layout. */
    private void show(boolean withWords, boolean withNetwork) {
        areWordsShown = withWords;
        starters.stream()
                .filter(button -> button.getHideActionText() == withWords)
                .forEach(button -> button.setHideActionText(!withWords));
        setVisible(network, withNetwork);
    }

    private static void setVisible(JLabel label, boolean isVisible) {
        if (label.isVisible() != isVisible) {
            label.setVisible(isVisible);
        }
    }

    private Lamp lamp(String name, String subjectKey) {
        Lamp lamp = new Lamp(texts.of(subjectKey));
        lamp.setName(name);
        return lamp;
    }

    void tick(long nowNanos) {
        rates.tick(nowNanos);
        showRates();
    }

    private void showRates() {
        rateLabel.setText(texts.of("window.rates", rates.messagesPerSecond(), rates.framesPerSecond()));
    }

    void show(ExchangeSnapshot snapshot) {
        rates.saw(snapshot);
        showCounts(snapshot.attached(), snapshot.calls().size(), snapshot.waiting());
    }

    private void showCounts(int attachedCount, int callCount, int waitingCount) {
        attached.show(
                attachedCount > 0 ? StatusMark.DISC : StatusMark.RING,
                attachedCount > 0 ? Ink.GOOD : Ink.QUIET,
                texts.of("window.count.attached", attachedCount));
        calls.show(
                callCount > 0 ? StatusMark.ARROW : StatusMark.RING,
                callCount > 0 ? Ink.ACCENT : Ink.QUIET,
                texts.of("window.count.calls", callCount));
        waiting.show(
                waitingCount > 0 ? StatusMark.DIAMOND : StatusMark.RING,
                waitingCount > 0 ? Ink.WARNING : Ink.QUIET,
                texts.of("window.count.waiting", waitingCount));
    }

    @Override
    protected void dress() {
        title.setFont(Theme.sans(20, true));
        network.setForeground(Theme.color(access == NetworkAccess.OPEN_TO_OTHERS ? Ink.WARNING : Ink.QUIET));
        rateLabel.setForeground(Theme.color(Ink.QUIET));
    }
}
