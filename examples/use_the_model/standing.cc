// The model of a robot description in a program of one's own: mass, centre of mass and mass matrix of the robot that
// stands with its feet under its hips.   usage: standing FILE.urdf
#include <cstdio>
#include <exception>
#include <robot/standing_pose.h>

#include <Eigen/Eigenvalues>

namespace {

// Largest over smallest eigenvalue: what an inverse loses. Units are mixed (kg, kg m, kg m^2), as in the paper.
double condition(const dob::Mat18& symmetric) {
  const Eigen::SelfAdjointEigenSolver<dob::Mat18> solver(symmetric, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().maxCoeff() / solver.eigenvalues().minCoeff();
}

void print_standing(const char* urdf) {
  const dob::Model model(dob::load_robot(urdf, dob::Forward::kMinusY));
  // CoM 0.40 m above ground, feet at (+-0.287, +-0.187) m; the angles [rad] say which way the legs bend.
  const dob::RobotState state = dob::standing_pose(model, 0.40, 0.287, 0.187,
                                                   {{"front_right_pitch", 0.886},
                                                    {"front_left_pitch", -0.884},
                                                    {"back_right_pitch", 0.886},
                                                    {"back_left_pitch", -0.884},
                                                    {"front_right_knee", 1.604},
                                                    {"front_left_knee", -1.604},
                                                    {"back_right_knee", 1.604},
                                                    {"back_left_knee", -1.604}});
  dob::ModelTerms terms;
  model.compute(state, terms);
  std::printf("mass %.3f kg\n", terms.mass);
  std::printf("centre of mass %.3f %.3f %.3f m, base %.3f %.3f %.3f m\n", terms.p_com.x(), terms.p_com.y(),
              terms.p_com.z(), state.p_WB.x(), state.p_WB.y(), state.p_WB.z());
  std::printf("condition of the mass matrix %.0f\n", condition(terms.mass_matrix()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: standing FILE.urdf\n");
    return 2;
  }
  try {
    print_standing(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "standing: %s\n", error.what());
    return 2;
  }
}
