package simgsm.ui;

import java.awt.Component;
import java.awt.Container;
import java.util.Optional;
import javax.swing.JComponent;

/** Names of components for tests and for assistive technology. */
public final class ComponentNames {
    private ComponentNames() {}

    /**
     * Sets both names of a component.
     *
     * @param componentName for tests, as {@code key.5}
     * @param accessibleName read by a screen reader
     * @return the component
     */
    public static <T extends JComponent> T name(T component, String componentName, String accessibleName) {
        component.setName(componentName);
        component.getAccessibleContext().setAccessibleName(accessibleName);
        return component;
    }

    /** Finds a component in a tree by its name. */
    public static Optional<Component> find(Component root, String componentName) {
        if (componentName.equals(root.getName())) {
            return Optional.of(root);
        }
        if (root instanceof Container container) {
            for (Component child : container.getComponents()) {
                Optional<Component> found = find(child, componentName);
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return Optional.empty();
    }
}
