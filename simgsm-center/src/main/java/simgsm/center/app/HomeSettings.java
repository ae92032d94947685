package simgsm.center.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.center.subscriber.HomeRegister;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.file.SecretFile;
import simgsm.sim.SimFile;

/**
 * The SIMs that may register.
 *
 * @param file lists the cards of a closed network; empty for an open one
 * @param cards of the file
 * @param countryCode for numbers in international form; empty for none
 */
public record HomeSettings(Optional<Path> file, SimFile cards, Set<Imei> barredEquipment, String countryCode) {
    /** @throws IOException naming the invalid file and line */
    static HomeSettings read(Arguments arguments) throws UsageException, IOException {
        Optional<Path> file = arguments.path("hlr");
        file.ifPresent(SecretFile::check);
        return new HomeSettings(
                file,
                file.isPresent() ? SimFile.read(file.get()) : SimFile.EMPTY,
                arguments.value("barred-imeis", HomeSettings::imeis).orElse(Set.of()),
                arguments.value("country-code", HomeSettings::countryCode).orElse(""));
    }

    private static String countryCode(String code) {
        HomeRegister.OPEN.inCountry(code);
        return code;
    }

    private static Set<Imei> imeis(String list) {
        Set<Imei> imeis = new LinkedHashSet<>();
        for (String imei : list.split(",", -1)) {
            imeis.add(new Imei(imei.strip()));
        }
        return imeis;
    }

    HomeRegister register() {
        Set<Imei> barred = new LinkedHashSet<>(barredEquipment);
        barred.addAll(cards.barredEquipment());
        HomeRegister home = isClosed() ? HomeRegister.closed(cards.subscriptions(), barred) : HomeRegister.open(barred);
        return home.inCountry(countryCode);
    }

    public boolean isClosed() {
        return file.isPresent();
    }

    /** The numbers of the cards, in the file's order. */
    public List<Msisdn> numbers() {
        return cards.subscriptions().stream()
                .filter(subscription -> !subscription.isBarred())
                .map(subscription -> subscription.card().number())
                .toList();
    }

    /** The options that start a terminal with this number. */
    public List<String> wordsFor(String number) {
        List<String> words = new ArrayList<>(List.of("--number", number));
        file.ifPresent(
                path -> words.addAll(List.of("--sim", path.toAbsolutePath().toString())));
        return words;
    }
}
