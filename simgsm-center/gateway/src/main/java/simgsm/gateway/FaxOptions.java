package simgsm.gateway;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.console.Arguments;
import simgsm.console.UsageException;

/**
 * The options of fax.
 *
 * @param number a message to it becomes a file
 * @param folder of the files; it exists
 */
record FaxOptions(SmppOptions smpp, Msisdn number, Path folder) {
    /** Empty without an option of fax. @throws IOException if the folder cannot be made */
    static Optional<FaxOptions> of(Arguments arguments) throws UsageException, IOException {
        if (!isUsed(arguments)) {
            return Optional.empty();
        }
        SmppOptions smpp = SmppOptions.of(arguments, "fax", "smpp", "fax-number", "fax");
        Path folder = arguments.path("fax").orElseThrow();
        Files.createDirectories(folder);
        if (!Files.isWritable(folder)) {
            throw new FileSystemException(folder.toString(), null, "the folder is write-protected");
        }
        return Optional.of(
                new FaxOptions(smpp, arguments.value("fax-number", Msisdn::new).orElseThrow(), folder));
    }

    static boolean isUsed(Arguments arguments) {
        return arguments.has("fax-number") || arguments.has("fax");
    }
}
