package simgsm.ui.window;

import java.awt.Component;
import java.awt.event.KeyEvent;
import java.util.Locale;
import javax.swing.Action;
import javax.swing.JButton;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import simgsm.console.TextBundle;
import simgsm.ui.CommandGroup;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Symbol;
import simgsm.ui.UserAction;

/** The button with three lines: its menu has the window's commands that have a group, in words, with their keys. */
public final class MenuButton extends JButton {
    private final TextBundle texts;

    public MenuButton(Locale language) {
        texts = DesktopTexts.in(language);
        UserAction open = new UserAction("window.menu", texts.of("window.menu"), this::open)
                .with(Symbol.MENU.icon())
                .described(texts.of("window.menu.why"));
        open.bindInWindow(this, KeyStroke.getKeyStroke(KeyEvent.VK_F10, 0));
        setAction(open);
        setHideActionText(true);
        setRequestFocusEnabled(false);
        ComponentNames.name(this, open.id(), open.name());
    }

    private void open() {
        menu(SwingUtilities.getRoot(this)).show(this, 0, getHeight());
    }

    JPopupMenu menu(Component root) {
        JPopupMenu menu = new JPopupMenu();
        JMenu submenu = null;
        CommandGroup before = null;
        for (WindowCommands.Command command : WindowCommands.of(root)) {
            if (command.action().group().isEmpty()) {
                continue;
            }
            if (command.group() != before) {
                before = command.group();
                submenu = (JMenu) menu.add(new JMenu(before.title(texts)));
            }
            submenu.add(item(command));
        }
        return menu;
    }

    private static JMenuItem item(WindowCommands.Command command) {
        UserAction action = command.action();
        JMenuItem item =
                action.getValue(Action.SELECTED_KEY) == null ? new JMenuItem(action) : new JCheckBoxMenuItem(action);
        item.setIcon(null);
        item.setMnemonic(0);
        item.setToolTipText(null);
        command.keys().stream().findFirst().ifPresent(item::setAccelerator);
        return item;
    }
}
