package simgsm.ui;

import javax.accessibility.Accessible;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;

/** A painted component that tells assistive technology in words what it shows. */
public abstract class SpokenComponent extends JComponent implements Accessible {
    private final transient AccessibleRole role;

    /** @param role LABEL for a reading, CANVAS for a picture */
    protected SpokenComponent(AccessibleRole role) {
        this.role = role;
    }

    /** What it shows now, in words. */
    protected abstract String spoken();

    /** Tells listeners that the words have changed. */
    protected final void tellSpoken(String before, String after) {
        if (accessibleContext != null && !before.equals(after)) {
            accessibleContext.firePropertyChange(AccessibleContext.ACCESSIBLE_NAME_PROPERTY, before, after);
        }
    }

    @Override
    public final AccessibleContext getAccessibleContext() {
        if (accessibleContext == null) {
            accessibleContext = new AccessibleJComponent() {
                @Override
                public AccessibleRole getAccessibleRole() {
                    return role;
                }

                @Override
                public String getAccessibleName() {
                    return spoken();
                }
            };
        }
        return accessibleContext;
    }
}
