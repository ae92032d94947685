package blackbox.peers;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** Human speech and music that Debian packages for Asterisk: none of it holds keys. */
enum Prompts {
    ENGLISH("asterisk-core-sounds-en-wav", "sounds/en_US_f_Allison"),
    SPANISH("asterisk-core-sounds-es-wav", "sounds/es_MX_f_Allison"),
    FRENCH("asterisk-core-sounds-fr-wav", "sounds/fr_CA_f_June"),
    COLOMBIAN("asterisk-prompt-es-co", "sounds/es"),
    MUSIC("asterisk-moh-opsound-wav", "moh");

    private final String debianPackage;
    private final Path folder;

    Prompts(String debianPackage, String folder) {
        this.debianPackage = debianPackage;
        this.folder = Path.of("/usr/share/asterisk", folder);
    }

    /** The recordings; without the package the test is skipped. */
    List<Path> files() throws Exception {
        Peer.require(Files.isDirectory(folder), debianPackage);
        try (Stream<Path> all = Files.walk(folder)) {
            return all.filter(file -> file.toString().matches(".*\\.(wav|gsm)"))
                    .sorted()
                    .toList();
        }
    }

    /** Every n-th recording, one after another, as a raw file. */
    Path sample(Path to, int everyNth) throws Exception {
        List<Path> all = files();
        List<String> arguments = new ArrayList<>();
        for (int i = everyNth / 2; i < all.size(); i += everyNth) {
            arguments.add(all.get(i).toString());
        }
        return raw(arguments, to.resolve(name() + ".raw"));
    }

    /** Some recordings as one raw file. */
    static Path raw(List<String> recordings, Path to) throws Exception {
        List<String> arguments = new ArrayList<>(recordings);
        arguments.addAll(List.of(Sound.RAW.split(" ")));
        arguments.add(to.toString());
        Peer.SOX.run(arguments.toArray(String[]::new)).expectSuccess();
        return to;
    }
}
