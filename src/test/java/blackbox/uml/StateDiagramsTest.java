package blackbox.uml;

import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.MainCode;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaModifier;
import java.lang.reflect.Field;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import simgsm.state.StateTable;

/** Each state table of the main code prints its state diagram. */
class StateDiagramsTest {
    /** Lies at the place that {@code vericommand --diagram} prints for. */
    private static final String STATUS = "vericommand.StatusMachine";

    @Test
    void theDiagramsAreThoseOfTheTables() throws Exception {
        Map<String, String> diagrams = new TreeMap<>();
        for (JavaClass owner : MainCode.CLASSES) {
            for (JavaField field : owner.getFields()) {
                if (field.getRawType().isEquivalentTo(StateTable.class)
                        && field.getModifiers().contains(JavaModifier.STATIC)
                        && !owner.getName().equals(STATUS)) {
                    StateTable<?, ?, ?> table = table(field);
                    diagrams.put(
                            "state-" + Diagram.fileName(table.name()) + ".puml",
                            table.plantUml().replace("!include look.iuml", "!include ../look.iuml"));
                }
            }
        }
        assertTrue(diagrams.size() >= 5, diagrams.keySet().toString());
        for (Map.Entry<String, String> diagram : diagrams.entrySet()) {
            Diagram.hold("design/" + diagram.getKey(), diagram.getValue());
        }
        Diagram.holdOnly("design", "state-", diagrams.keySet());
    }

    private static StateTable<?, ?, ?> table(JavaField field) throws Exception {
        Field constant = field.reflect();
        constant.setAccessible(true);
        return (StateTable<?, ?, ?>) constant.get(null);
    }
}
