package simgsm.ui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.console.TextBundle;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.CommandGroup;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

class HelpDialogTest {
    private final JPanel window = new JPanel();

    @BeforeEach
    void keys() {
        Theme.install(Appearance.LIGHT);
        new UserAction("power", "Switch the robot on", () -> {})
                .onKey(window, KeyEvent.VK_P, InputEvent.CTRL_DOWN_MASK);
        new UserAction("hidden", "", () -> {}).onKey(window, KeyEvent.VK_Q, InputEvent.CTRL_DOWN_MASK);
        window.add(new JButton(new UserAction("new", "New &phone", () -> {})));
    }

    private static List<String> commands(Component root) {
        return commands(root, Locale.ENGLISH);
    }

    private static List<String> commands(Component root, Locale language) {
        TextBundle texts = DesktopTexts.in(language);
        return WindowCommands.of(root).stream()
                .map(command -> command.action().name() + ": " + command.keysText(texts))
                .toList();
    }

    @ParameterizedTest
    @CsvSource({"en, Menu: Menu key, Far: Ctrl+Shift+Page Up", "es, Menu: tecla Menú, Far: Ctrl+Mayús+Re Pág"})
    void keysAreNamedAsOnTheKeyboardsOfTheLanguage(String language, String menu, String far) {
        JPanel phone = new JPanel();
        new UserAction("menu", "Menu", () -> {}).onKey(phone, KeyEvent.VK_CONTEXT_MENU, 0);
        new UserAction("far", "Far", () -> {})
                .onKey(phone, KeyEvent.VK_PAGE_UP, InputEvent.CTRL_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK);
        assertEquals(Set.of(menu, far), Set.copyOf(commands(phone, Locale.forLanguageTag(language))));
    }

    @Test
    void theMenuHasTheCommandsOfTheTableByGroupWithTheirKeysAndWhatIsOn() {
        MenuButton button = new MenuButton(Locale.ENGLISH);
        UserAction trail = new UserAction("trail", "Trail", () -> {})
                .in(CommandGroup.VIEW)
                .onKey(window, KeyEvent.VK_T, InputEvent.ALT_DOWN_MASK);
        trail.setOn(true);
        new UserAction("call", "Call", () -> {}).in(CommandGroup.CALL).bindInWindow(window);
        JPopupMenu menu = button.menu(window);
        assertEquals(
                List.of("Phone", "View"),
                Stream.of(menu.getComponents())
                        .map(each -> ((JMenu) each).getText())
                        .toList());
        JMenuItem shown = ((JMenu) menu.getComponent(1)).getItem(0);
        assertTrue(shown instanceof JCheckBoxMenuItem && shown.isSelected());
        assertEquals(KeyStroke.getKeyStroke(KeyEvent.VK_T, InputEvent.ALT_DOWN_MASK), shown.getAccelerator());
    }

    @Test
    void allNamedKeysAndMnemonicsAreListed() {
        assertEquals(List.of("Switch the robot on: Ctrl+P", "New phone: Alt+P"), commands(window));
    }

    @Test
    void keysWithASignAreShownByIt() {
        JPanel zoomed = new JPanel();
        new UserAction("larger", "Larger", () -> {}).onKey(zoomed, KeyEvent.VK_EQUALS, InputEvent.CTRL_DOWN_MASK);
        assertEquals(List.of("Larger: Ctrl+="), commands(zoomed));
    }

    @Test
    void keysOfTheNumberPadAreLeftOutAndNoRowOfKeysIsCut() {
        JPanel zoomed = new JPanel();
        WindowKeys.install(zoomed, Locale.ENGLISH);
        JPanel content = HelpDialog.content(zoomed, "A robot.", "1.0.0", DesktopTexts.in(Locale.ENGLISH));
        JTable keys = (JTable) ComponentNames.find(content, "help.keys").orElseThrow();
        int larger = IntStream.range(0, keys.getRowCount())
                .filter(row -> keys.getValueAt(row, 2).equals("Larger"))
                .findFirst()
                .orElseThrow();
        assertEquals("Ctrl++,  Ctrl+=,  Ctrl+Shift+=", keys.getValueAt(larger, 1));
        keys.setSize(400, 400);
        keys.doLayout();
        int needed =
                keys.prepareRenderer(keys.getCellRenderer(larger, 1), larger, 1).getPreferredSize().width;
        assertTrue(needed <= keys.getCellRect(larger, 1, false).width);
    }

    @Test
    void aMessageHasSeveralLinesAndFitsASmallScreen() {
        JTextArea message = HelpDialog.message(DesktopTexts.in(Locale.ENGLISH).of("lessons.ends"));
        assertTrue(
                message.getPreferredSize().width <= 400,
                message.getPreferredSize().toString());
        assertTrue(message.getPreferredSize().height
                > 2 * message.getFontMetrics(message.getFont()).getHeight());
    }

    @Test
    void keysOfAPanelAreListed() {
        JPanel phone = new JPanel();
        new UserAction("message", "Write a message", () -> {})
                .bind(phone, JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, KeyStroke.getKeyStroke(KeyEvent.VK_F2, 0));
        assertEquals(List.of("Write a message: F2"), commands(phone));
    }

    @Test
    void keysOfAHiddenPageAreNotListed() {
        JPanel editor = new JPanel();
        new UserAction("wall", "Draw a wall", () -> {}).onKey(editor, KeyEvent.VK_W, InputEvent.CTRL_DOWN_MASK);
        window.add(editor);
        assertEquals(3, commands(window).size());
        editor.setVisible(false);
        assertEquals(2, commands(window).size());
    }

    @Test
    void theTextTheKeysAndTheVersionAreShown() {
        JPanel content = HelpDialog.content(window, "A robot.", "1.0.0", DesktopTexts.in(Locale.ENGLISH));
        JTextArea about = (JTextArea) ComponentNames.find(content, "help.about").orElseThrow();
        JTable keys = (JTable) ComponentNames.find(content, "help.keys").orElseThrow();
        assertEquals("A robot.", about.getText());
        assertEquals(2, keys.getRowCount());
        assertTrue(ComponentNames.unnamed(content).isEmpty());
    }

    /** The border's painter comes after the text. */
    @Test
    void theTextIsPaintedWhereItStandsWithoutAScrollPane() {
        JPanel content = HelpDialog.content(window, "A robot.", "1.0.0", DesktopTexts.in(Locale.ENGLISH));
        JTextArea about = (JTextArea) ComponentNames.find(content, "help.about").orElseThrow();
        about.setSize(300, 40);
        BufferedImage image = new BufferedImage(300, 40, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setColor(Theme.color(Ink.SURFACE));
        g.fillRect(0, 0, 300, 40);
        about.paint(g);
        g.dispose();
        int text = Theme.color(Ink.TEXT).getRGB();
        assertTrue(IntStream.range(0, 300 * 40).anyMatch(i -> image.getRGB(i % 300, i / 300) == text));
    }

    @Test
    void paragraphsTakeANewSizeAndHaveNoBoxBehindThem() {
        JPanel help = HelpDialog.content(window, "About.", "1", DesktopTexts.in(Locale.ENGLISH));
        try {
            Theme.zoomTo(2);
            SwingUtilities.updateComponentTreeUI(help);
            Component about = ComponentNames.find(help, "help.about").orElseThrow();
            assertEquals(Theme.base(), about.getFont());
            assertEquals(0, about.getBackground().getAlpha());
        } finally {
            Theme.zoomTo(1);
        }
    }
}
