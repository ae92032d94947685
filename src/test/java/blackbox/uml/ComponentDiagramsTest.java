package blackbox.uml;

import blackbox.MainCode;
import java.lang.module.ModuleDescriptor;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Components: the modules, from their descriptors. */
class ComponentDiagramsTest {
    private static final Map<String, String> PROGRAMS = Map.of(
            "simgsm.center", "M3, the centre",
            "simgsm.phone", "M1, the phone",
            "simrobot", "SimRobot",
            "simgsm.tools", "tools",
            "vericommand", "VeriCommand");

    @Test
    void modulesAndWhatTheyRequire() throws Exception {
        Map<String, Set<String>> requires = new TreeMap<>();
        for (ModuleDescriptor module : MainCode.descriptors()) {
            requires.put(
                    module.name(),
                    module.requires().stream()
                            .map(ModuleDescriptor.Requires::name)
                            .filter(name -> !name.equals("java.base"))
                            .collect(Collectors.toCollection(TreeSet::new)));
        }
        StringBuilder uml = new StringBuilder(Diagram.head("Modules and what they require"));
        uml.append("note \"An arrow that a longer way implies is left out.\" as hint\n");
        requires.keySet()
                .forEach(name -> uml.append("component \"")
                        .append(PROGRAMS.containsKey(name) ? "<b>" + name + "</b>\\n" + PROGRAMS.get(name) : name)
                        .append("\" as ")
                        .append(name)
                        .append('\n'));
        requires.values().stream()
                .flatMap(Set::stream)
                .distinct()
                .sorted()
                .filter(name -> !requires.containsKey(name))
                .forEach(name -> uml.append("component \"")
                        .append(name)
                        .append("\\n(JDK)\" as ")
                        .append(name)
                        .append(" #F6F7F9\n"));
        append(uml, Arrows.reduced(requires));
        Diagram.hold("implementation/modules.puml", uml.append("@enduml\n").toString());
    }

    private static void append(StringBuilder uml, Map<String, Set<String>> arrows) {
        arrows.forEach((from, targets) -> targets.forEach(
                to -> uml.append(from).append(" --> ").append(to).append('\n')));
    }
}
