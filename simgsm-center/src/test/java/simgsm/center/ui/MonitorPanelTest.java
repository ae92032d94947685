package simgsm.center.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Queue;
import java.util.ResourceBundle;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import javax.accessibility.Accessible;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JSpinner;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.center.msc.BroadcastOrder;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.msc.call.CallProgress;
import simgsm.center.msc.call.CallView;
import simgsm.console.TextBundle;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.Drawing;
import simgsm.ui.Lamp;
import simgsm.ui.Theme;

@ExtendWith(OnEventThread.class)
class MonitorPanelTest {
    private final List<String> acts = new ArrayList<>();
    private MonitorPanel panel;
    private NetworkAccess access = NetworkAccess.OPEN;

    @BeforeEach
    void buildInEnglish() {
        Theme.install(Appearance.LIGHT);
        panel = build("en");
    }

    @AfterEach
    void lightAgain() {
        Theme.install(Appearance.LIGHT);
        Theme.zoomTo(1);
    }

    @ParameterizedTest
    @CsvSource({
        "en,OPEN,open network",
        "en,OPEN_TO_OTHERS,open to other machines",
        "en,CLOSED,closed network",
        "es,OPEN,red abierta",
        "es,OPEN_TO_OTHERS,abierta a otras m\u00e1quinas",
        "es,CLOSED,red cerrada"
    })
    void theHeaderNamesTheNetworksAccess(String language, NetworkAccess who, String words) {
        access = who;
        panel = build(language);

        JLabel network = find("network", JLabel.class);
        assertEquals(words, network.getText());
        assertFalse(network.getToolTipText().isEmpty());
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everyControlHasANameWithoutTheMarkOfItsMnemonic(String language) {
        panel = build(language);
        assertEquals(List.of(), ComponentNames.unnamed(panel));
    }

    @Test
    void anEmptyExchangeShowsZeros() {
        panel.show(Scene.empty());

        assertEquals("0 attached", lamp("lamp.attached"));
        assertEquals("0 calls", lamp("lamp.calls"));
        assertEquals("0 waiting", lamp("lamp.waiting"));
        assertEquals("port 3003", lamp("lamp.port"));
        assertEquals("", field("tel.incoming"));
        assertEquals("0001 3003", field("tel.intermediate"));
    }

    @Test
    void aBusyExchangeShowsItsCountsInWords() {
        panel.show(Scene.busy());

        assertEquals("2 attached", lamp("lamp.attached"));
        assertEquals("1 call", lamp("lamp.calls"));
        assertEquals("1 waiting", lamp("lamp.waiting"));
    }

    @Test
    void theFiguresFieldsShowTheMessageThatPassed() {
        panel.show(Scene.busy());

        assertEquals("5550100", field("tel.incoming"));
        assertEquals("5550200", field("tel.outgoing"));
        assertEquals("** #*#90 **", field("message"));
    }

    @ParameterizedTest
    @CsvSource({"en, 1", "es, 1", "es, 1.5"})
    void theFiguresFieldsHaveRoomForNumbersOfTenDigits(String language, double zoom) {
        Theme.install(Appearance.LIGHT, zoom);
        panel = build(language);
        panel.setSize(Theme.px(980), Theme.px(640));
        layOut(panel);
        for (String name : List.of("tel.incoming", "tel.intermediate", "tel.outgoing")) {
            JTextField field = find(name, JTextField.class);
            int room = field.getWidth() - field.getInsets().left - field.getInsets().right;
            assertTrue(room >= Drawing.width(field.getFont(), "9115550100"), name + ": " + room);
        }
    }

    @Test
    void aCallIsShownByItsStateUntilItIsOver() {
        Optional<ExchangeSnapshot.Passing> call =
                Optional.of(new ExchangeSnapshot.Passing(Scene.PHONE, Scene.ROBOT.digits(), ""));
        panel.show(Scene.with(call, List.of(new CallView(Scene.PHONE, "5550200", CallProgress.ALERTING, 0))));
        assertEquals("(call, alerting)", field("message"));

        panel.show(Scene.with(call, List.of()));
        assertEquals("(call, over)", field("message"));
    }

    @Test
    void theTablesShowTheSnapshotsRows() {
        panel.show(Scene.busy());

        assertEquals("5550100 attached 001010005550100 001017500000017", row("subscribers", 0));
        assertEquals("5550201 detached 001010005550201 ", row("subscribers", 2));
        assertEquals("5550100 5550200 active 01:15 ", row("calls", 0));
        assertTrue(row("messages", 0).startsWith("5550100 5550201 "), row("messages", 0));
        assertTrue(row("messages", 0).endsWith(" ** #**20 **"), row("messages", 0));
    }

    @ParameterizedTest
    @CsvSource({"INITIATED", "ALERTING", "ACTIVE", "RELEASED"})
    void everyStateOfACallHasAWord(CallProgress state) {
        panel.show(Scene.with(Optional.empty(), List.of(new CallView(Scene.PHONE, "", state, 0))));

        assertFalse(row("calls", 0).contains("window."), row("calls", 0));
    }

    @Test
    void aChosenRowStaysChosenWhenOthersChange() {
        panel.show(Scene.busy());
        JTable subscribers = find("subscribers", JTable.class);
        subscribers.setRowSelectionInterval(1, 1);
        ExchangeSnapshot before = Scene.busy();
        List<ExchangeSnapshot.SubscriberRow> fewer =
                List.of(before.subscribers().get(0), before.subscribers().get(2));
        panel.show(new ExchangeSnapshot(
                Scene.NOON,
                1,
                1,
                0,
                0,
                fewer,
                List.of(),
                List.of(),
                List.of(),
                0,
                Optional.empty(),
                List.of(),
                List.of()));

        assertEquals(0, subscribers.getSelectedRow());
        assertEquals("5550200", String.valueOf(subscribers.getValueAt(0, 0)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"subscribers", "ladder.detail"})
    void aTableKeepsItsCellsWhenTheThemeChanges(String name) {
        panel.show(Scene.busy());
        find("ladder.list", JList.class).setSelectedIndex(1);
        JTable table = find(name, JTable.class);
        Class<?> cells = table.getDefaultRenderer(Object.class).getClass();

        Theme.install(Appearance.DARK);
        SwingUtilities.updateComponentTreeUI(panel);

        assertEquals(cells, table.getDefaultRenderer(Object.class).getClass());
    }

    @Test
    void theLadderHoldsEveryMessageAndTellsTheChosenOne() {
        panel.show(Scene.busy());
        JList<?> list = find("ladder.list", JList.class);
        assertEquals(Scene.everyKind().size(), list.getModel().getSize());

        list.setSelectedIndex(1);

        assertTrue(find("ladder.title", JLabel.class).getText().startsWith("Setup   5550100 → M3"));
        JTable detail = find("ladder.detail", JTable.class);
        assertEquals("called", detail.getValueAt(2, 0));
        assertEquals("5550200", detail.getValueAt(2, 1));
    }

    @Test
    void aWindowThatIsLowShowsTheMessageAmongTheListsAndLeavesTheLadderItsRoom() {
        panel.show(Scene.busy());
        panel.setSize(1300, 400);
        layOut(panel);
        layOut(panel);
        JTextField incoming = find("tel.incoming", JTextField.class);
        JTextField message = find("message", JTextField.class);
        assertEquals(yOf(incoming), yOf(message));
        JComponent list = find("ladder.list", JComponent.class);
        int room = list.getParent().getHeight();

        find("ladder.list", JList.class).setSelectedIndex(1);
        layOut(panel);

        JTabbedPane tabs = find("tabs", JTabbedPane.class);
        assertEquals("ladder.message", tabs.getSelectedComponent().getName());
        assertTrue(list.getParent().getHeight() >= room, "room " + room);
        assertTrue(room >= 10 * find("ladder.list", JList.class).getFixedCellHeight(), "room " + room);

        panel.setSize(1300, 800);
        layOut(panel);
        assertEquals(4, tabs.getTabCount());
    }

    /** As the demo opens the window at 1366x768 and at 1280x720; a call has 14 messages. */
    @ParameterizedTest
    @CsvSource({"1028, 296, false, 14", "942, 262, false, 10", "942, 262, true, 14", "1263, 352, false, 20"})
    void aLowWindowShowsTheMessagesOfACallInColumns(int width, int height, boolean alone, int messages) {
        panel.show(Scene.passing(101));
        panel.setSize(width, height);
        layOut(panel);
        if (alone) {
            find("ladder.alone", AbstractButton.class).doClick(0);
        }
        layOut(panel);
        layOut(panel);
        JList<?> list = find("ladder.list", JList.class);
        int last = list.getModel().getSize() - 1;
        JComponent seen = (JComponent) list.getParent();
        Rectangle end = list.getCellBounds(last, last);
        Rectangle screen = new Rectangle(end.x + end.width - seen.getWidth(), 0, seen.getWidth(), seen.getHeight());

        long shown = IntStream.rangeClosed(0, last)
                .filter(i -> screen.contains(list.getCellBounds(i, i)))
                .count();
        assertTrue(shown >= messages, "messages " + shown);
        assertEquals(seen.getHeight() / list.getFixedCellHeight(), 1 + end.y / list.getFixedCellHeight());
    }

    @Test
    void theListsAreFoldedInALowWindowAndAChosenMessageUnfoldsThem() {
        panel.show(Scene.busy());
        panel.setSize(1028, 290);
        layOut(panel);
        JComponent tabs = find("tabs", JComponent.class);
        AbstractButton lists = find("lists.shown", AbstractButton.class);
        assertFalse(tabs.getParent().getParent().getParent().isVisible());
        assertFalse(lists.isSelected());

        find("ladder.list", JList.class).setSelectedIndex(2);
        assertTrue(lists.isSelected());
        press("ladder.list", KeyEvent.VK_ESCAPE);
        assertFalse(lists.isSelected());

        panel.setSize(1160, 700);
        layOut(panel);
        assertTrue(lists.isSelected());
    }

    @Test
    void theLadderAloneHidesTheRestAndGivesItBack() {
        panel.show(Scene.busy());
        panel.setSize(1160, 700);
        layOut(panel);
        press("ladder.list", KeyEvent.VK_F11);
        layOut(panel);
        assertFalse(find("network", JComponent.class).getParent().getParent().isVisible());
        assertFalse(find("lists.shown", AbstractButton.class).isSelected());
        int alone = find("ladder.list", JComponent.class).getParent().getHeight();

        press("ladder.list", KeyEvent.VK_ESCAPE);
        layOut(panel);
        assertTrue(find("network", JComponent.class).getParent().getParent().isVisible());
        assertTrue(find("lists.shown", AbstractButton.class).isSelected());
        assertTrue(find("ladder.list", JComponent.class).getParent().getHeight() < alone - 80);
    }

    /** As when the component has the focus: the nearest binding around it counts, then those of the window. */
    private void press(String name, int key) {
        KeyStroke stroke = KeyStroke.getKeyStroke(key, 0);
        for (int condition :
                List.of(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, JComponent.WHEN_IN_FOCUSED_WINDOW)) {
            Component at = find(name, JComponent.class);
            while (at instanceof JComponent component) {
                Object action = component.getInputMap(condition).get(stroke);
                if (action != null && component.getActionMap().get(action) != null) {
                    component.getActionMap().get(action).actionPerformed(new ActionEvent(component, 0, ""));
                    return;
                }
                at = at.getParent();
            }
        }
        throw new AssertionError("no key " + stroke);
    }

    @Test
    void aClearedLadderIsShownAgain() {
        panel.show(Scene.busy());
        assertFalse(find("ladder.undo", JComponent.class).isVisible());
        press("ladder.clear");
        press("ladder.undo");

        assertEquals(
                Scene.everyKind().size(),
                find("ladder.list", JList.class).getModel().getSize());
        assertFalse(find("ladder.undo", JComponent.class).isVisible());
    }

    /** At 1366x768, in a tall window, and in one that is as large as the screen. */
    @ParameterizedTest
    @CsvSource({"1028, 296", "1160, 700", "1900, 1000"})
    void aFollowedLadderStaysAtItsEndWhileTheListsComeAndGo(int width, int height) {
        panel.show(Scene.passing(101));
        panel.setSize(width, height);
        layOut(panel);
        layOut(panel);
        settle();
        assertEndIsSeen("at first");
        for (int press = 1; press <= 4; press++) {
            press("lists.shown");
            settle();
            assertEndIsSeen("after press " + press);
        }
        panel.setSize(width - 100, height - 60);
        settle();
        assertEndIsSeen("in a smaller window");
    }

    /** Sizes and what follows from them, as the event queue would bring them. */
    private void settle() {
        for (int i = 0; i < 3; i++) {
            layOut(panel);
            OnEventThread.performEvents();
        }
    }

    private void assertEndIsSeen(String when) {
        JList<?> list = find("ladder.list", JList.class);
        int last = list.getModel().getSize() - 1;
        Rectangle end = list.getCellBounds(last, last);
        Rectangle seen = list.getVisibleRect();
        assertTrue(seen.contains(end), when + ": " + end + " in " + seen);
    }

    private int yOf(JComponent component) {
        return SwingUtilities.convertPoint(component, 0, 0, panel).y;
    }

    @Test
    void aSubscribersRowNarrowsTheLadderToIt() {
        panel.show(Scene.busy());
        find("subscribers", JTable.class).setRowSelectionInterval(1, 1);

        assertEquals(1, find("ladder.list", JList.class).getModel().getSize());
        assertEquals("5550200", find("ladder.who", JComboBox.class).getSelectedItem());

        find("ladder.who", JComboBox.class).setSelectedIndex(0);
        assertEquals(
                Scene.everyKind().size(),
                find("ladder.list", JList.class).getModel().getSize());
    }

    @ParameterizedTest
    @CsvSource({"en,1024", "es,1024", "en,880", "es,880", "en,960", "es,960", "en,1100", "es,1100"})
    void theTwoFiltersOfTheLadderAreToldApartAndLeaveRoomForTheTextThatIsSought(String language, int width) {
        panel = build(language);
        panel.setSize(width, 400);
        layOut(panel);
        JComboBox<?> who = find("ladder.who", JComboBox.class);
        JComboBox<?> kind = find("ladder.kind", JComboBox.class);
        assertNotEquals(who.getItemAt(0), kind.getItemAt(0));
        assertFalse(who.getToolTipText().isEmpty());
        int sought = find("ladder.find", JTextField.class).getWidth();
        assertTrue(sought >= 100, sought + " pixels");
    }

    @Test
    void clearEmptiesTheLadder() {
        panel.show(Scene.busy());
        press("ladder.clear");

        assertEquals(0, find("ladder.list", JList.class).getModel().getSize());
    }

    @Test
    void theButtonsAskTheOperator() {
        press("new.phone");
        press("new.robot");
        press("window.quit");

        assertEquals(List.of("phone", "robot", "quit"), acts);
    }

    @Test
    void theBrowsersLinkHasAButtonWhereThereIsOne() {
        assertTrue(ComponentNames.find(panel, "window.link").isEmpty());
        panel = new MonitorPanel(
                texts("en"),
                new NotingOperator() {
                    @Override
                    public Optional<Runnable> link() {
                        return Optional.of(() -> acts.add("link"));
                    }
                },
                Background.NONE);
        press("window.link");

        assertEquals(List.of("link"), acts);
    }

    @Test
    void aProgramThatDoesNotStartIsReportedInWords() {
        panel = new MonitorPanel(
                texts("en"),
                new NotingOperator() {
                    @Override
                    public void newPhone() throws IOException {
                        throw new IOException("simgsm-phone.jar is missing");
                    }
                },
                Background.NONE);
        press("new.phone");

        assertEquals(
                "Could not be started: simgsm-phone.jar is missing",
                find("notice", JLabel.class).getText());
    }

    @Test
    void theEventThreadDoesNotWaitForTheCentre() {
        Queue<Runnable> waiting = new ArrayDeque<>();
        panel = new MonitorPanel(texts("en"), new NotingOperator(), new Background(waiting::add, Runnable::run));
        find("broadcast.text", JTextArea.class).setText("Hello");
        press("new.phone");
        press("broadcast.send");

        assertEquals(List.of(), acts);
        assertFalse(find("broadcast.send", AbstractButton.class).isEnabled());
        assertEquals("Hello", find("broadcast.text", JTextArea.class).getText());
        waiting.forEach(Runnable::run);
        assertEquals(List.of("phone", "broadcast 50 Hello"), acts);
        assertEquals("", find("broadcast.text", JTextArea.class).getText());
    }

    @Test
    void theContentOfAChannelIsNamed() {
        JLabel name = find("broadcast.channel.name", JLabel.class);
        assertEquals("area names", name.getText());
        find("broadcast.channel", JSpinner.class).setValue(4370);
        assertEquals("public warnings", name.getText());
        find("broadcast.channel", JSpinner.class).setValue(6400);
        assertEquals("", name.getText());
    }

    @Test
    void aBroadcastIsSentOnItsChannelAndTheTextGoesAway() {
        find("broadcast.channel", JSpinner.class).setValue(221);
        find("broadcast.text", JTextArea.class).setText("The robot moves.");
        assertEquals(
                "16 characters, 1 page", find("broadcast.pages", JLabel.class).getText());
        press("broadcast.send");

        assertEquals(List.of("broadcast 221 The robot moves."), acts);
        assertEquals("", find("broadcast.text", JTextArea.class).getText());
        assertEquals(
                "Sent on channel 221.", find("broadcast.result", JLabel.class).getText());
    }

    @ParameterizedTest
    @CsvSource({"0, 1", "1, 1", "1, 1.5"})
    void aLowWindowStillHasRoomForABroadcastsText(int repeated, double zoom) {
        Theme.zoomTo(zoom);
        panel = build("es");
        panel.show(Scene.broadcasting(repeated));
        find("tabs", JTabbedPane.class).setSelectedIndex(3);
        panel.setSize((int) (1262 * zoom), (int) (395 * zoom));
        layOut(panel);
        find("lists.shown", AbstractButton.class).doClick(0);
        layOut(panel);
        layOut(panel);

        JTextArea text = find("broadcast.text", JTextArea.class);
        int twoLines = 2 * text.getFontMetrics(text.getFont()).getHeight();
        assertTrue(
                text.getParent().getHeight() >= twoLines,
                "height " + text.getParent().getHeight());
        assertEquals(repeated > 0, find("broadcast.stop", JComponent.class).isVisible());
    }

    @ParameterizedTest
    @CsvSource({"0, false", "1, true", "1395, true", "1396, false"})
    void onlyATextThatFitsCanBeSent(int length, boolean canBeSent) {
        find("broadcast.text", JTextArea.class).setText("a".repeat(length));

        assertEquals(canBeSent, find("broadcast.send", AbstractButton.class).isEnabled());
    }

    @Test
    void aRefusedBroadcastKeepsItsTextAndSaysWhy() {
        panel = new MonitorPanel(
                texts("en"),
                new NotingOperator() {
                    @Override
                    public void broadcast(BroadcastOrder order) {
                        throw new IllegalArgumentException("no subscriber is attached");
                    }
                },
                Background.NONE);
        find("broadcast.text", JTextArea.class).setText("Hello");
        press("broadcast.send");

        assertEquals("Hello", find("broadcast.text", JTextArea.class).getText());
        assertEquals(
                "no subscriber is attached",
                find("broadcast.result", JLabel.class).getText());
    }

    @ParameterizedTest
    @CsvSource({"en, LIGHT, 1, 1", "es, DARK, 0.8, 2", "es, LIGHT, 1.5, 1.25", "en, DARK, 1, 1"})
    void everyTabIsPaintedWithoutADisplay(String language, Appearance appearance, double zoom, double scale) {
        Theme.install(appearance);
        Theme.zoomTo(zoom);
        panel = build(language);
        panel.show(Scene.busy());
        JTabbedPane tabs = find("tabs", JTabbedPane.class);
        for (int tab = 0; tab < tabs.getTabCount(); tab++) {
            tabs.setSelectedIndex(tab);
            BufferedImage image = paint(scale);
            assertTrue(count(image, Ink.SURFACE) > 1000, "surface");
            assertTrue(count(image, Ink.CARD) > 10_000, "cards");
            assertTrue(count(image, Ink.ACCENT) > 200, "the centre's lifeline");
        }
    }

    @Test
    void anEmptyWindowIsPaintedToo() {
        panel.show(Scene.empty());

        assertTrue(count(paint(1), Ink.CARD) > 10_000);
    }

    @Test
    void appearanceAndZoomChangeTheWholeWindow() {
        panel.show(Scene.busy());
        Theme.install(Appearance.DARK);
        Theme.refresh(panel);
        int normal = panel.getPreferredSize().width;
        assertTrue(count(paint(1), Ink.SURFACE) > 1000);

        Theme.zoomTo(1.5);
        Theme.refresh(panel);
        assertEquals(Math.round(normal * 1.5), panel.getPreferredSize().width, 2);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everythingThatCanBeUsedHasAnAccessibleName(String language) {
        panel = build(language);
        panel.show(Scene.busy());

        List<String> nameless = new ArrayList<>();
        walk(panel, component -> {
            boolean usable = component instanceof AbstractButton
                    || component instanceof JTable
                    || component instanceof JList
                    || component instanceof JTextField
                    || component instanceof JTextArea
                    || component instanceof JComboBox;
            boolean ours = component.getName() != null
                    && !component.getName().contains("Spinner")
                    && !component.getName().contains("ScrollBar")
                    && !component.getName().contains("ComboBox");
            if (usable && ours && isNameless((Accessible) component)) {
                nameless.add(component.getName());
            }
        });
        assertEquals(List.of(), nameless);
    }

    private static boolean isNameless(Accessible component) {
        String name = component.getAccessibleContext().getAccessibleName();
        return name == null || name.isBlank();
    }

    private MonitorPanel build(String language) {
        return new MonitorPanel(texts(language), new NotingOperator(), Background.NONE);
    }

    private static TextBundle texts(String language) {
        Locale locale = TextBundle.bundleLocale(Locale.forLanguageTag(language));
        return new TextBundle(ResourceBundle.getBundle("simgsm.center.app.messages", locale), Locale.ROOT);
    }

    private BufferedImage paint(double scale) {
        panel.setSize(panel.getPreferredSize());
        layOut(panel);
        BufferedImage image = new BufferedImage(
                (int) Math.ceil(panel.getWidth() * scale),
                (int) Math.ceil(panel.getHeight() * scale),
                BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(scale, scale);
        panel.printAll(g);
        g.dispose();
        return image;
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    private static int count(BufferedImage image, Ink ink) {
        int wanted = Theme.color(ink).getRGB();
        int count = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                count += image.getRGB(x, y) == wanted ? 1 : 0;
            }
        }
        return count;
    }

    private <T extends JComponent> T find(String name, Class<T> type) {
        return type.cast(
                ComponentNames.find(panel, name).orElseThrow(() -> new AssertionError("no component named " + name)));
    }

    private String lamp(String name) {
        return find(name, Lamp.class).word();
    }

    private String field(String name) {
        return find(name, JTextField.class).getText();
    }

    private String row(String table, int row) {
        JTable found = find(table, JTable.class);
        List<String> cells = new ArrayList<>();
        for (int column = 0; column < found.getColumnCount(); column++) {
            cells.add(String.valueOf(found.getValueAt(row, column)));
        }
        return String.join(" ", cells);
    }

    private void press(String name) {
        AbstractButton button = find(name, AbstractButton.class);
        button.getAction().actionPerformed(new ActionEvent(button, ActionEvent.ACTION_PERFORMED, name));
    }

    private static void walk(Component component, Consumer<Component> visitor) {
        visitor.accept(component);
        if (component instanceof Container container) {
            for (Component child : container.getComponents()) {
                walk(child, visitor);
            }
        }
    }

    private class NotingOperator implements CenterActions {
        @Override
        public int port() {
            return 3003;
        }

        @Override
        public NetworkAccess access() {
            return access;
        }

        @Override
        public Optional<ExchangeSnapshot> snapshot() {
            return Optional.empty();
        }

        @Override
        public void stopBroadcast(int id) {
            acts.add("stop " + id);
        }

        @Override
        public void broadcast(BroadcastOrder order) {
            acts.add("broadcast " + order.channel() + " " + order.text());
        }

        @Override
        public void newPhone() throws IOException {
            acts.add("phone");
        }

        @Override
        public void newRobot() throws IOException {
            acts.add("robot");
        }

        @Override
        public void quit() {
            acts.add("quit");
        }
    }
}
