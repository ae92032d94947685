package simgsm.gateway;

import java.nio.file.Path;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.console.Arguments;
import simgsm.console.UsageException;

/**
 * The options of fax.
 *
 * @param number a message to it becomes a file
 * @param folder of the files
 */
record FaxOptions(SmppOptions smpp, Msisdn number, Path folder) {
    /** Empty without an option of fax. */
    static Optional<FaxOptions> of(Arguments arguments) throws UsageException {
        if (!isUsed(arguments)) {
            return Optional.empty();
        }
        SmppOptions smpp = SmppOptions.of(arguments, "fax", "smpp", "fax-number", "fax");
        return Optional.of(new FaxOptions(
                smpp,
                arguments.value("fax-number", Msisdn::new).orElseThrow(),
                arguments.path("fax").orElseThrow()));
    }

    static boolean isUsed(Arguments arguments) {
        return arguments.has("fax-number") || arguments.has("fax");
    }
}
