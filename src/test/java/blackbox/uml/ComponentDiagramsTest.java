package blackbox.uml;

import blackbox.MainCode;
import java.lang.module.ModuleDescriptor;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Components: the modules from their descriptors, and the packages of each module from the compiled classes. */
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

    @Test
    void packagesOfEachModule() throws Exception {
        Map<String, Set<String>> arrows = Arrows.betweenPackages();
        Map<String, String> moduleOf = new TreeMap<>();
        MainCode.descriptors().forEach(module -> module.packages().forEach(name -> moduleOf.put(name, module.name())));
        Set<String> files = new TreeSet<>();
        for (Path folder : MainCode.FOLDERS) {
            ModuleDescriptor module = MainCode.descriptor(folder);
            Set<String> inside = new TreeSet<>(module.packages());
            inside.retainAll(arrows.keySet());
            if (inside.size() < 2) {
                continue;
            }
            String file = "packages-" + Diagram.fileName(module.name()) + ".puml";
            files.add(file);
            Diagram.hold("implementation/" + file, packages(module, inside, arrows, moduleOf));
        }
        Diagram.holdOnly("implementation", "packages-", files);
    }

    private static String packages(
            ModuleDescriptor module,
            Set<String> inside,
            Map<String, Set<String>> arrows,
            Map<String, String> moduleOf) {
        Map<String, Set<String>> shown = new TreeMap<>();
        Set<String> others = new TreeSet<>();
        for (String name : inside) {
            Set<String> targets = arrows.get(name).stream()
                    .map(to -> inside.contains(to) ? to : moduleOf.get(to))
                    .collect(Collectors.toCollection(TreeSet::new));
            shown.put(name, targets);
            targets.stream().filter(to -> !inside.contains(to)).forEach(others::add);
        }
        StringBuilder uml = new StringBuilder(Diagram.head("Packages of the module " + module.name()));
        uml.append("note \"An arrow that a longer way implies is left out.\" as hint\n");
        uml.append("package \"").append(module.name()).append(".jar\" {\n");
        inside.forEach(name ->
                uml.append("  [").append(name).append("] as ").append(id(name)).append('\n'));
        uml.append("}\n");
        others.forEach(name -> uml.append("component \"module ")
                .append(name)
                .append("\" as module_")
                .append(id(name))
                .append(" #F6F7F9\n"));
        Arrows.reduced(shown)
                .forEach((from, targets) -> targets.forEach(to -> uml.append(id(from))
                        .append(" --> ")
                        .append(inside.contains(to) ? id(to) : "module_" + id(to))
                        .append('\n')));
        return uml.append("@enduml\n").toString();
    }

    private static String id(String name) {
        return name.replace('.', '_');
    }

    private static void append(StringBuilder uml, Map<String, Set<String>> arrows) {
        arrows.forEach((from, targets) -> targets.forEach(
                to -> uml.append(from).append(" --> ").append(to).append('\n')));
    }
}
