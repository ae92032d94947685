package simgsm.trace;

import java.util.List;
import java.util.Optional;
import simgsm.air.Coded;
import simgsm.air.ProtocolViolation;
import simgsm.air.SupplementaryService;
import simgsm.air.SupplementaryService.SsFacility;
import simgsm.air.SupplementaryService.SsRegister;
import simgsm.air.SupplementaryService.SsReleaseComplete;
import simgsm.octets.OctetString;
import simgsm.ss.Component;
import simgsm.ss.ComponentCodec;
import simgsm.ss.ComponentFault;
import simgsm.ss.SsError;
import simgsm.ss.SsOperation;
import simgsm.ss.UssdText;
import simgsm.trace.MessageText.Field;

/** The component of a supplementary service message in words. */
final class ComponentText {
    private ComponentText() {}

    /** What the message asks or answers, for its name; empty without a component. */
    static Optional<String> nameOf(SupplementaryService message) {
        return facilityOf(message).map(ComponentText::nameOf);
    }

    /** What a facility element does. */
    static String nameOf(OctetString facility) {
        try {
            return name(ComponentCodec.decode(facility));
        } catch (ComponentFault fault) {
            return "unreadable component";
        }
    }

    private static Optional<OctetString> facilityOf(SupplementaryService message) {
        if (message instanceof SsRegister register) {
            return Optional.of(register.facility());
        }
        return message instanceof SsFacility facility
                ? Optional.of(facility.facility())
                : ((SsReleaseComplete) message).facility();
    }

    private static String name(Component component) {
        if (component instanceof Component.Invoke invoke) {
            return operation(invoke.operation());
        }
        if (component instanceof Component.ReturnResult result) {
            return "result"
                    + result.operation().map(code -> " " + operation(code)).orElse("");
        }
        return component instanceof Component.ReturnError error
                ? "error " + error(error.error())
                : "reject " + ((Component.Reject) component).problem().title();
    }

    private static String operation(int code) {
        return SsOperation.ofCode(code).map(Coded.Titled::title).orElse("operation " + code);
    }

    private static String error(int code) {
        return SsError.ofCode(code).map(Coded.Titled::title).orElse("" + code);
    }

    /** Adds the parts of a facility element. */
    static void add(List<Field> fields, OctetString facility) {
        try {
            Component component = ComponentCodec.decode(facility);
            if (component instanceof Component.Invoke invoke) {
                fields.add(new Field("invoke", "" + invoke.id()));
                addOperation(fields, invoke.operation(), invoke.argument());
            } else if (component instanceof Component.ReturnResult result) {
                fields.add(new Field("result of invoke", "" + result.id()));
                result.operation().ifPresent(operation -> addOperation(fields, operation, result.result()));
            } else if (component instanceof Component.ReturnError error) {
                fields.add(new Field("error of invoke", "" + error.id()));
                fields.add(new Field("error", error.error() + " " + error(error.error())));
            } else if (component instanceof Component.Reject reject) {
                fields.add(new Field(
                        "reject of invoke", reject.id().map(String::valueOf).orElse("unknown")));
                fields.add(new Field("problem", reject.problem().title()));
            }
        } catch (ComponentFault fault) {
            fields.add(new Field("wrong", fault.getMessage()));
        }
    }

    private static void addOperation(List<Field> fields, int operation, OctetString parameter) {
        fields.add(new Field("operation", operation + " " + operation(operation)));
        if (parameter.length() > 0) {
            try {
                fields.add(new Field("text", UssdText.decode(parameter).text()));
            } catch (ProtocolViolation noText) {
                fields.add(new Field("parameter", parameter.toString()));
            }
        }
    }
}
