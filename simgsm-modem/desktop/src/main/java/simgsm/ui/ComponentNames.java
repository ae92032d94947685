package simgsm.ui;

import java.awt.Component;
import java.awt.Container;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JSpinner;
import javax.swing.KeyStroke;

/** Names of components for tests and for assistive technology. */
public final class ComponentNames {
    private ComponentNames() {}

    /**
     * Sets both names of a component.
     *
     * @param componentName for tests, as {@code key.5}
     * @param accessibleName read by a screen reader; a mark of a mnemonic ({@code &} before a letter) is left out
     * @return the component
     */
    public static <T extends JComponent> T name(T component, String componentName, String accessibleName) {
        component.setName(componentName);
        String spoken = accessibleName.replaceFirst("&(?=\\p{L})", "");
        component.getAccessibleContext().setAccessibleName(spoken);
        if (component instanceof JSpinner spinner && spinner.getEditor() instanceof JSpinner.DefaultEditor editor) {
            // The field takes the focus, not the spinner around it.
            editor.getTextField().getAccessibleContext().setAccessibleName(spoken);
        }
        return component;
    }

    /** The components of a tree that take the keyboard focus and have no accessible name, or one with a mnemonic's mark. */
    public static List<Component> unnamed(Component root) {
        return all(root).filter(ComponentNames::isUnnamed).toList();
    }

    private static boolean isUnnamed(Component each) {
        if (!each.isFocusable() || !(each instanceof JComponent component) || !hasKeys(component)) {
            return false;
        }
        String name = component.getAccessibleContext().getAccessibleName();
        return name == null || name.isBlank() || name.contains("&");
    }

    /** The components of a tree, each before its children. */
    public static Stream<Component> all(Component root) {
        return root instanceof Container container
                ? Stream.concat(
                        Stream.of(root), Stream.of(container.getComponents()).flatMap(ComponentNames::all))
                : Stream.of(root);
    }

    /** Panels and labels are focusable by default, but have no keys. */
    private static boolean hasKeys(JComponent component) {
        KeyStroke[] keys = component.getInputMap(JComponent.WHEN_FOCUSED).allKeys();
        return keys != null && keys.length > 0;
    }

    /** Finds a component in a tree by its name. */
    public static Optional<Component> find(Component root, String componentName) {
        return all(root).filter(each -> componentName.equals(each.getName())).findFirst();
    }
}
