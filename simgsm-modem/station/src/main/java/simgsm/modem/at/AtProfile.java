package simgsm.modem.at;

import java.util.List;
import java.util.Locale;

/**
 * Forms of answers that differ between TS 27.007 and a module's manual, and the names that the modem reports for
 * itself.
 */
public enum AtProfile {
    /** TS 27.007. */
    PLAIN("SimGSM", "", "Revision:1.0", "", "0,100", ",,,,"),
    /** SIM800 Series AT Command Manual V1.09; clients recognise the type by the first line of ATI. */
    SIM800(
            "SIMCOM_Ltd",
            "SIMCOM_SIM800L",
            "Revision:1308B08SIM800L16",
            "SIM800 R13.08",
            "0,100,4200",
            ",\"\",0,\"\",",
            "RDY",
            "+CFUN: 1");

    public final String manufacturer;
    public final String revision;
    /** Charging state and percent; the manual's form also has millivolts. */
    public final String battery;
    /** Fields of +CLIP between the number's type and its validity. */
    public final String callerFields;
    /** Codes after power-on, before +CPIN and registration. */
    public final List<String> bootCodes;

    private final String model;
    private final String information;

    AtProfile(
            String manufacturer,
            String model,
            String revision,
            String information,
            String battery,
            String callerFields,
            String... bootCodes) {
        this.manufacturer = manufacturer;
        this.model = model;
        this.revision = revision;
        this.information = information;
        this.battery = battery;
        this.callerFields = callerFields;
        this.bootCodes = List.of(bootCodes);
    }

    /** The profile of a lower-case name; IllegalArgumentException for another. */
    public static AtProfile named(String name) {
        for (AtProfile profile : values()) {
            if (profile.name().toLowerCase(Locale.ROOT).equals(name)) {
                return profile;
            }
        }
        throw new IllegalArgumentException("expected plain or sim800, found " + name);
    }

    /** The model's name: the manual's, else the terminal's own. */
    public String model(String own) {
        return model.isEmpty() ? own : model;
    }

    /** The lines of ATI. */
    public List<String> information(String ownModel) {
        return information.isEmpty() ? List.of(manufacturer, ownModel, revision) : List.of(information);
    }

    /** The answer to +CCID; in the manual's form without name and quotation marks. */
    public String cardNumber(String iccid) {
        return this == SIM800 ? iccid : "+CCID: " + AtRequest.quoted(iccid);
    }

    /** True if +CNMI is 2,1,0,0,0 without a setting: SIM800 reports stored messages with +CMTI. */
    public boolean reportsMessages() {
        return this == SIM800;
    }

    /** True if the profile has codes of a modem that has started. */
    public boolean boots() {
        return !bootCodes.isEmpty();
    }
}
