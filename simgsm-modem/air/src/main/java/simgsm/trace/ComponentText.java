package simgsm.trace;

import java.util.ArrayList;
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

/** The component of a supplementary service message in words. */
final class ComponentText {
    private final FieldList fields;
    private final int start;
    private final List<Integer> elementEnds;
    private int at;

    private ComponentText(FieldList fields, List<Integer> elementEnds, int start) {
        this.fields = fields;
        this.elementEnds = new ArrayList<>(elementEnds);
        this.start = start;
        at = start;
    }

    /** The request or answer of the message, for its name; empty without a component. */
    static Optional<String> nameOf(SupplementaryService message) {
        return facilityOf(message).map(ComponentText::nameOf);
    }

    /** The operation of a facility element. */
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

    /** Adds the parts of a facility element. @param start index of its value in the message */
    static void add(FieldList fields, OctetString facility, int start) {
        try {
            Component component = ComponentCodec.decode(facility);
            new ComponentText(fields, ComponentCodec.elementEnds(facility), start).add(component);
        } catch (ComponentFault fault) {
            fields.add(MessageText.WRONG, fault.getMessage());
        }
    }

    private void add(Component component) {
        if (component instanceof Component.Invoke invoke) {
            next("invoke", invoke.id());
            addOperation(invoke.operation(), invoke.argument());
        } else if (component instanceof Component.ReturnResult result) {
            next("resultOfInvoke", result.id());
            result.operation().ifPresent(operation -> addOperation(operation, result.result()));
        } else if (component instanceof Component.ReturnError error) {
            next("errorOfInvoke", error.id());
            next("error", error.error() + " " + error(error.error()));
        } else if (component instanceof Component.Reject reject) {
            next(
                    "rejectOfInvoke",
                    reject.id()
                            .map(String::valueOf)
                            .orElseGet(() -> fields.texts().of("unknown")));
            next("problem", reject.problem().title());
        }
    }

    private void addOperation(int operation, OctetString parameter) {
        next("operation", operation + " " + operation(operation));
        if (parameter.length() > 0) {
            try {
                next("text", UssdText.decode(parameter).text());
            } catch (ProtocolViolation noText) {
                next("parameter", parameter);
            }
        }
    }

    /** Adds the field of the component's next element. */
    private void next(String key, Object value) {
        int end = elementEnds.isEmpty() ? at : start + elementEnds.remove(0);
        fields.add(key, value, at, end);
        at = end;
    }
}
